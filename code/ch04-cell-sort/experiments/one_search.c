// One search over cells, and nothing else, for a simulator of branches
// and caches: `uniform` points or a `lattice`, C points in a cell, and
// a search of bench.h.
//     one_search KIND C SEARCH [POINTS]
#include "ch04-cell-sort/experiments/bench.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    if (argc < 4)
        fail("usage: one_search KIND C SEARCH [POINTS]");
    e.next = 4; // behind those three
    uint32_t n = parameter(&e, "POINTS", 102400, 2, MANY);
    struct question question = kind_question(argv[1], n, 1);
    question.space.geometry = WRAPAROUND;
    struct bench bench = bench_make(question, atof(argv[2]));
    struct trial trial = bench_trial(&bench, argv[3]);
    trial.work(trial.context);
}
