// The boxes of all pieces, for a picture: left, bottom, right, top, and
// how many points. Then, with n = 0, some of the points themselves.
//
//     boxes [POINTS]
#include "ch11-crowds/pieces.h"
#include "common/experiment.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 100, MANY);
    struct question question = kind_question("kuzmin", n, 1);
    struct workspace workspace = {0};
    const struct pieces pieces = pieces_make(&question, &workspace);
    print_header(&e, "left bottom right top n");
    for (uint32_t k = 0; k < pieces.leaves; k++)
        for (uint32_t i = 0; i < pieces.count[k]; i++) {
            const struct piece *piece =
                &pieces.piece[pieces.first[k] + i];
            const struct box *r = &piece->region;
            row("%.6g\t%.6g\t%.6g\t%.6g\t%u", fmax(r->left, -1e4),
                fmax(r->bottom, -1e4), fmin(r->right, 1e4),
                fmin(r->top, 1e4), piece->sorted.points.n);
        }
    for (uint32_t i = 0; i < n; i += n / 2000 + 1)
        row("%.6g\t%.6g\t0\t0\t0", question.points.x[i],
            question.points.y[i]);
    workspace_free(&workspace);
    forget();
    return 0;
}
