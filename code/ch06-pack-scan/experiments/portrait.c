// Draw the escape times.
// A picture of the plane: the steps of each of its points, a row of
// the table for a row of the picture.
//     portrait [WIDTH [LIMIT]]
#include "ch06-pack-scan/escape.h"
#include "common/experiment.h"
#include "common/report.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t width = parameter(&e, "WIDTH", 240, 4, 10000);
    uint32_t limit = parameter(&e, "LIMIT", 256, 1, MANY);
    uint32_t height = width / 4 * 3;
    struct points c = picture(width, height);
    struct lanes lanes = lanes_allocate(c.n);
    double *steps = take(c.n, sizeof *steps);
    escape(primitives(isa_chosen()), c, limit, 32, &lanes, steps);
    report_provenance(stdout);
    for (uint32_t column = 0; column < width; column++)
        printf("%sc%u", column ? "\t" : "", column);
    for (uint32_t i = 0; i < c.n; i++)
        printf("%c%.0f", i % width ? '\t' : '\n', steps[i]);
    row_end();
}
