// See caches.h. Linux has a folder for each cache, with a file for its
// level, its type and its size.
#include "ch06-pack-scan/experiments/caches.h"
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

// The first word of a file about cache number index.
static bool read_word(int index, const char *file, char word[static 32])
{
    char path[80];
    snprintf(path, sizeof path,
             "/sys/devices/system/cpu/cpu0/cache/index%d/%s", index,
             file);
    FILE *in = fopen(path, "r");
    bool read = in && fscanf(in, "%31s", word) == 1;
    if (in)
        fclose(in);
    return read;
}

struct caches caches_of_machine(void)
{
    size_t sizes[3] = {32, 512, 8192}; // in units of 1024 bytes
    char level[32], type[32], size[32];
    for (int index = 0; read_word(index, "level", level) &&
                        read_word(index, "type", type) &&
                        read_word(index, "size", size);
         index++) {
        size_t number = level[0] - '1';
        if (number < 3 && strcmp(type, "Instruction") != 0)
            sscanf(size, "%zuK", &sizes[number]);
    }
    return (struct caches){sizes[0] << 10, sizes[1] << 10,
                           sizes[2] << 10};
}
