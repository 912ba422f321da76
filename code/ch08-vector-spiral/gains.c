//> Time every version
// The spiral search, point by point and in step, each with its sort,
// and the search of chapter 4 that asks together: nanoseconds a point,
// each version right after itself.
//
//     gains [POINTS [TRIALS]]
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/together.h"
#include "ch07-spiral/spiral.h"
#include "ch08-vector-spiral/vector_spiral.h"
#include "ch08-vector-spiral/versions.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/isa.h"
#include "common/report.h"
#include <stdio.h>

static const struct {
    const char *name;
    search_function *search;
} versions[] = {{"spiral", spiral},
                {"in_order", spiral_in_order},
                {"primitives_plain", march_primitives_plain},
                {"primitives", march_primitives},
                {"fused_plain", march_fused_plain},
                {"fused", vector_spiral},
                {"together", cells_together}};
enum { VERSIONS = sizeof versions / sizeof *versions };

static const char *const kinds[] = {"uniform", "clustered", "circle",
                                    "kuzmin"};
enum { KINDS = sizeof kinds / sizeof *kinds };

static void time_kind(const char *kind, uint32_t n, int trials)
{
    struct question question = kind_question(kind, n, 1);
    struct answers answers = answers_allocate(n);
    struct search search[VERSIONS];
    struct trial trial[VERSIONS];
    for (int v = 0; v < VERSIONS; v++) {
        search[v] =
            (struct search){versions[v].search, question, &answers};
        trial[v] = (struct trial){.work = run_search,
                                  .context = &search[v],
                                  .prepare = run_search};
    }
    time_in_turn(trials, trial, VERSIONS);
    for (int v = 0; v < VERSIONS; v++) {
        printf("%s_%s\t%s\t%u", versions[v].name, kind,
               isa_names[isa_chosen()], n);
        print_summary(&trial[v].summary, n);
        puts("");
    }
    answers_free(&answers);
    points_free(&question.points);
}

// On Kuzmin's disc everybody meets everybody.
int main(int argc, char **argv)
{
    enum { FEW = 20000 };
    fail_as("gains");
    uint32_t n = argument(argc, argv, 1, "POINTS", 20000, 8, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    report_provenance(stdout);
    puts("name\tisa\tn\tns\tns_q1\tns_q3");
    for (int k = 0; k < KINDS - 1; k++)
        time_kind(kinds[k], n, trials);
    time_kind(kinds[KINDS - 1], n < FEW ? n / 4 : FEW / 4, 1);
    return 0;
}
//<
