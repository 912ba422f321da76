//> Tell where the numbers come from
// See report.h. What cannot be found out is called unknown.
#include "common/report.h"
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

//> Ask the machine for its name
static void processor(char name[static 128])
{
    strcpy(name, "unknown");
    FILE *cpuinfo = fopen("/proc/cpuinfo", "r");
    char line[256];
    while (cpuinfo && fgets(line, sizeof line, cpuinfo))
        if (sscanf(line, "model name : %127[^\n]", name) == 1)
            break;
    if (cpuinfo)
        fclose(cpuinfo);
}
//<

//> Head a table with its provenance
void report_provenance(FILE *out)
{
    char cpu[128], date[32];
    processor(cpu);
    time_t now = time(NULL);
    strftime(date, sizeof date, "%Y-%m-%d %H:%M", localtime(&now));
    fprintf(out, "# machine: %s, %ld cores\n", cpu,
            sysconf(_SC_NPROCESSORS_ONLN));
    fprintf(out, "# compiler: %s\n", COMPILER);
    fprintf(out, "# flags: %s\n", BUILD_FLAGS);
    fprintf(out, "# date: %s\n", date);
}
//<

//> Make a word of a name
void print_word(FILE *out, const char *name)
{
    for (; *name; name++)
        putc(*name == '-' ? '_' : *name, out);
}
//<
//<
