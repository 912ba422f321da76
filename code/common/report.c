// Prints the processor, its caches, memory, the compiler with its flags
// and the date. Linux tells its machine in files, under /proc and /sys;
// what cannot be found out is called unknown.
#include "common/report.h"
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#ifndef BUILD_FLAGS
#define BUILD_FLAGS "unknown"
#endif

#ifdef __clang__
#define COMPILER __VERSION__ // begins with its name
#else
#define COMPILER "gcc " __VERSION__
#endif

// A name without a number, like "AMD EPYC", is that of many processors:
// then the family and the model say which.
static void processor(char name[static 160])
{
    char line[256];
    int family = -1, model = -1;
    strcpy(name, "unknown");
    FILE *cpuinfo = fopen("/proc/cpuinfo", "r");
    while (cpuinfo && fgets(line, sizeof line, cpuinfo) &&
           line[0] != '\n') {
        sscanf(line, "model name : %127[^\n]", name);
        sscanf(line, "cpu family : %d", &family);
        sscanf(line, "model : %d", &model);
    }
    if (cpuinfo)
        fclose(cpuinfo);
    size_t length = strlen(name);
    if (model >= 0 && !strpbrk(name, "0123456789"))
        snprintf(name + length, 160 - length, " (family %d, model %d)",
                 family, model);
}

bool cache_says(int k, const char *what, char word[static 16])
{
    char path[80];
    snprintf(path, sizeof path,
             "/sys/devices/system/cpu/cpu0/cache/index%d/%s", k, what);
    FILE *file = fopen(path, "r");
    bool said = file && fscanf(file, "%15s", word) == 1;
    if (file)
        fclose(file);
    return said;
}

// The caches for data, from the smallest on.
static void print_caches(FILE *out)
{
    char type[16], level[16], size[16];
    const char *separator = "";
    fprintf(out, "# caches: ");
    for (int k = 0; cache_says(k, "type", type); k++) {
        if (type[0] == 'I' || !cache_says(k, "level", level) ||
            !cache_says(k, "size", size))
            continue;
        int kib = atoi(size);
        bool large = kib % 1024 == 0;
        fprintf(out, "%sL%s%s %d %s", separator, level,
                type[0] == 'D' ? "d" : "", large ? kib / 1024 : kib,
                large ? "MiB" : "KiB");
        separator = ", ";
    }
    fprintf(out, "%s\n", separator[0] ? "" : "unknown");
}

void report_provenance(FILE *out)
{
    char cpu[160], date[32];
    processor(cpu);
    time_t now = time(NULL);
    strftime(date, sizeof date, "%Y-%m-%d %H:%M", localtime(&now));
    fprintf(out, "# machine: %s, %ld cores\n", cpu,
            sysconf(_SC_NPROCESSORS_ONLN));
    print_caches(out);
    double bytes =
        (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
    fprintf(out, "# memory: %.0f GiB\n", bytes / (1 << 30));
    fprintf(out, "# compiler: %s\n", COMPILER);
    fprintf(out, "# flags: %s\n", BUILD_FLAGS);
    fprintf(out, "# date: %s\n", date);
}
