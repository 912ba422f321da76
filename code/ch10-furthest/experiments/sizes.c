// The whole time a point of the furthest by cells, by the hull and by
// regions, of both answers in one go, and of the nearest by row spans,
// on one thread, from a thousand points on: in the standard geometry
// and, where a search knows it, with wraparound.
//     sizes [MOST]
#include "common/experiment.h"

static const struct {
    const char *algorithm;
    enum geometry geometry;
    unsigned answers;
} curves[] = {{"row-spans", STANDARD, NEAREST},
              {"furthest-cells", STANDARD, FURTHEST},
              {"furthest-hull", STANDARD, FURTHEST},
              {"near-and-far", STANDARD, FURTHEST},
              {"near-and-far", STANDARD, NEAREST | FURTHEST},
              {"row-spans", WRAPAROUND, NEAREST},
              {"furthest-cells", WRAPAROUND, FURTHEST},
              {"near-and-far", WRAPAROUND, NEAREST | FURTHEST}};
enum { CURVES = COUNT_OF(curves), SEVERAL = 1000000 };

static void print_points(uint32_t n)
{
    struct question question = uniform_question(STANDARD, n, 1);
    struct workspace workspace = {0};
    question.workspace = &workspace;
    struct trial trial[CURVES];
    for (int k = 0; k < CURVES; k++) {
        question.space.geometry = curves[k].geometry;
        trial[k] =
            search_trial(find_algorithm(curves[k].algorithm)->run,
                         &question, new_answers(n, curves[k].answers));
        trial[k].prepare = trial[k].work;
    }
    time_in_turn(n > SEVERAL ? 1 : 5, trial, CURVES);
    row_of_times(trial, CURVES, n, "n%u\t%u", n, n);
    workspace_free(&workspace);
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 300000, 1000, MANY);
    print_header(&e, "name n spans:3 cells:3 hull:3 far:3 both:3"
                     " spans_wrapped:3 cells_wrapped:3 both_wrapped:3");
    for (uint32_t n = 1000; n <= most; n = next_size(n))
        print_points(n);
}
