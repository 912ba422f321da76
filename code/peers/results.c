//> Print the results
// See results.h.
#include "peers/results.h"
#include "common/report.h"
#include <math.h>

void print_columns(FILE *out)
{
    fputs("name\tprogram\tkind\tn\torder\tleaf\ttrials", out);
    static const char *const what[] = {"build",     "query",
                                       "total",     "build_all",
                                       "query_all", "total_all"};
    for (int k = 0; k < 6; k++)
        fprintf(out, "\t%s\t%s_q1\t%s_q3", what[k], what[k], what[k]);
    fputs("\texpected\tdiffer\n", out);
}

//> Print the times with one thread or all
static void print_one(FILE *out, struct summary summary, double n)
{
    fprintf(out, "\t%.4g\t%.4g\t%.4g", summary.median / n,
            summary.q1 / n, summary.q3 / n);
}

static void print_times(FILE *out, const struct times *times,
                        bool measured, uint32_t n)
{
    static const struct summary none = {NAN, NAN, NAN, NAN, NAN};
    print_one(out, measured ? times->build : none, n);
    print_one(out, measured ? times->query : none, n);
    print_one(out, measured ? times->total : none, n);
}
//<

void print_result(FILE *out, const char *program, const char *kind,
                  uint32_t n, const char *order, int leaf,
                  const struct result *result)
{
    const bool run = result->trials > 0;
    print_word(out, program);
    fprintf(out, "_%s_%u_%s", kind, n, order);
    fprintf(out, "\t%s\t%s\t%u\t%s\t%d\t%d", program, kind, n, order,
            leaf, result->trials);
    print_times(out, &result->one, run, n);
    print_times(out, &result->all, run && result->threaded, n);
    fprintf(out, "\t%.4g\t%u\n", run ? NAN : result->expected / n,
            run ? result->differ : 0);
}
//<
