// What it would take to keep every distance of 100,000 points, in a
// square, a triangle or a hash table: computed, not measured.
#include "common/experiment.h"

struct distance {
    uint32_t i, j;
    double distance;
};

struct node { // of a chained hash table
    struct node *next;
    struct distance distance;
};

static const struct {
    const char *layout;
    bool triangle; // or the square
    size_t size;
} tables[] = {
    {"square of doubles", false, sizeof(double)},
    {"triangle of floats", true, sizeof(float)},
    {"triangle of doubles", true, sizeof(double)},
    {"two doubles, near and far", true, 2 * sizeof(double)},
    {"key and double, no gaps", true, sizeof(struct distance)},
    {"the same and a tag byte", true, sizeof(struct distance) + 1},
    {"list nodes and buckets", true,
     sizeof(struct node) + sizeof(struct node *)},
};

int main(void)
{
    const double n = 1e5;
    row("%-26s %5s %6s %6s", "", "bytes", "GB", "GiB");
    for (int t = 0; t < COUNT_OF(tables); t++) {
        double count = tables[t].triangle ? n * (n - 1) / 2 : n * n;
        double bytes = count * tables[t].size;
        row("%-26s %5zu %6.1f %6.1f", tables[t].layout, tables[t].size,
            bytes / 1e9, bytes / (1 << 30));
    }
}
