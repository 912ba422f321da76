// Distances and cells a point over c, and what the report's formula
// gives. No point is generated.
#include "ch07-spiral/experiments/expected.h"
#include "common/experiment.h"

// Named by c in tenths: c2, c10.
int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    print_header(&e, "name c distances cells printed one_more");
    for (int tenths = 2; tenths <= 80; tenths += 2) {
        double c = tenths / 10.0;
        struct expected expected = expected_spiral(c);
        row("c%d\t%g\t%.6g\t%.6g\t%.6g\t%.6g", tenths, c,
            expected.distances, expected.cells, expected_printed(c),
            expected_one_more(c));
    }
}
