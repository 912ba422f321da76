// The last version with blocks of 16, 32, ... candidates: small ones
// are noted too often, large ones take long to search again.
//     block-size [POINTS [ROWS [TRIALS]]]
#include "ch02-all-pairs/tiles.h"
#include "common/experiment.h"

enum { SIZES = 9 };

struct blocked {
    struct question question;
    struct answers *answers;
    uint32_t rows, block;
};

static void run_blocked(void *context)
{
    struct blocked *b = context;
    tiles_blocked_rows(&b->question, b->answers, 0, b->rows, b->block);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 8192, 2, MANY);
    uint32_t rows = parameter(&e, "ROWS", 512, 1, n);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    struct blocked sizes[SIZES];
    struct trial versions[SIZES];
    for (int s = 0; s < SIZES; s++) {
        sizes[s] = (struct blocked){question, answers, rows, 16u << s};
        versions[s] =
            (struct trial){.work = run_blocked, .context = &sizes[s]};
    }
    time_in_turn(trials, versions, SIZES);
    print_header(&e, "name block ns:3");
    for (int s = 0; s < SIZES; s++)
        row_of_times(&versions[s], 1, (double)rows * (n - 1),
                     "block_%u\t%u", sizes[s].block, sizes[s].block);
}
