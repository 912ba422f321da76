//> Print what is expected
// Distances and cells a point over c, and what the report's formula
// gives. No point is generated.
//
//     expect
#include "ch07-spiral/expected.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

// Named by c in tenths: c2, c10.
int main(void)
{
    fail_as("expect");
    report_provenance(stdout);
    puts("name\tc\tdistances\tcells\tprinted\tone_more");
    for (int tenths = 2; tenths <= 80; tenths += 2) {
        double c = tenths / 10.0;
        struct expected expected = expected_spiral(c);
        printf("c%d\t%g\t%.6g\t%.6g\t%.6g\t%.6g\n", tenths, c,
               expected.distances, expected.cells, expected_printed(c),
               expected_one_more(c));
    }
    return 0;
}
//<
