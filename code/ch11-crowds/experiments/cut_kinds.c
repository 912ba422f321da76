// Points of every kind are generated and cut into pieces, one kind at a
// time: what it needs is given up before the next one is cut.
#include "ch11-crowds/experiments/cut_kinds.h"
#include "common/experiment.h"
#include "common/generate.h"

void cut_one_kind(const char *name, uint32_t n, look_function *look)
{
    struct workspace workspace = {0};
    struct cut_kind kind = {.name = name,
                            .question = kind_question(name, n, 1)};
    kind.pieces = pieces_make(&kind.question, &workspace);
    kind.results = workspace_take(&workspace, n, sizeof *kind.results);
    look(&kind);
    workspace_free(&workspace);
    forget();
}

uint32_t cut_all_kinds(int argc, char **argv, const char *names,
                       look_function *look)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    print_header(&e, names);
    for (int d = 0; d < distribution_count; d++)
        cut_one_kind(distributions[d].name, n, look);
    return n;
}
