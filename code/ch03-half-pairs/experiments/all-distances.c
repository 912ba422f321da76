// What it would take to keep every distance of 100,000 points.
#include "common/experiment.h"
#include <stddef.h>
#include <stdint.h>

int main(void)
{
    const double n = 1e5, pairs = n * (n - 1) / 2;
    struct distance {
        uint32_t i, j;
        double distance;
    };
    struct node { // of a chained hash table
        struct node *next;
        struct distance distance;
    };
    const struct {
        const char *layout;
        double count, size;
    } tables[] = {
        {"square of doubles", n * n, sizeof(double)},
        {"triangle of floats", pairs, sizeof(float)},
        {"triangle of doubles", pairs, sizeof(double)},
        {"two doubles, near and far", pairs, 2 * sizeof(double)},
        {"key and double, no gaps", pairs, sizeof(struct distance)},
        {"the same and a tag byte", pairs, sizeof(struct distance) + 1},
        {"list nodes and buckets", pairs,
         sizeof(struct node) + sizeof(struct node *)},
    };
    row("%-26s %5s %6s %6s", "", "bytes", "GB", "GiB");
    for (size_t t = 0; t < sizeof tables / sizeof *tables; t++) {
        double bytes = tables[t].count * tables[t].size;
        row("%-26s %5.0f %6.1f %6.1f", tables[t].layout, tables[t].size,
            bytes / 1e9, bytes / (1 << 30));
    }
    return 0;
}
