// The spiral search, point by point and in step, each with its sort,
// and the batched search of chapter 4: nanoseconds a point,
// each version right after itself.
//     gains [POINTS [TRIALS]]
#include "ch04-cell-sort/batches.h"
#include "ch07-spiral/spiral.h"
#include "ch08-vector-spiral/experiments/versions.h"
#include "ch08-vector-spiral/vector_spiral.h"
#include "common/experiment.h"

static const struct {
    const char *name;
    search_function *search;
} versions[] = {{"spiral", spiral},
                {"in_order", spiral_in_order},
                {"primitives_plain", spiral_primitives_plain},
                {"primitives", spiral_primitives},
                {"fused_plain", spiral_fused_plain},
                {"fused", vector_spiral},
                {"together", cells_batched}};
enum { VERSIONS = COUNT_OF(versions) };

static const char *const kinds[] = {"uniform", "clustered", "circle",
                                    "kuzmin"};

static void time_kind(const char *kind, uint32_t n, int trials)
{
    struct question question = kind_question(kind, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    struct trial trial[VERSIONS];
    for (int v = 0; v < VERSIONS; v++) {
        trial[v] = search_trial(versions[v].search, &question, answers);
        trial[v].prepare = trial[v].work;
    }
    time_in_turn(trials, trial, VERSIONS);
    for (int v = 0; v < VERSIONS; v++)
        row_of_times(&trial[v], 1, n, "%s_%s\t%s\t%u", versions[v].name,
                     kind, isa_names[isa_chosen()], n);
    forget();
}

// On Kuzmin's disc every pair is compared.
int main(int argc, char **argv)
{
    enum { FEW = 20000 };
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 8, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    print_header(&e, "name isa n ns:3");
    for (int k = 0; k < COUNT_OF(kinds) - 1; k++)
        time_kind(kinds[k], n, trials);
    time_kind(kinds[COUNT_OF(kinds) - 1], n < FEW ? n / 4 : FEW / 4, 1);
}
