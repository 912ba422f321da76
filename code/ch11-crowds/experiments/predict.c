// Sums over the cells of all pieces. The integral of the density over a
// cell is its value at the middle, times the area: a cell is small.
#include "ch11-crowds/experiments/predict.h"
#include "common/random.h"
#include <math.h>
#include <stddef.h>
#include <string.h>

// ---- densities -----------------------------------------------------
static const double PI = 3.14159265358979323846;

static double uniform(double x, double y, uint64_t seed)
{
    (void)seed;
    return x >= 0 && x <= 1 && y >= 0 && y <= 1;
}

// The centers are drawn as the generator draws them.
static double clustered(double x, double y, uint64_t seed)
{
    enum { CENTERS = 10 };
    const double scale = 0.1;
    struct random random = {seed};
    double sum = 0;
    for (int k = 0; k < CENTERS; k++) {
        const double dx = (x - random_uniform(&random)) / scale;
        const double dy = (y - random_uniform(&random)) / scale;
        sum += exp(-(dx * dx + dy * dy) / 2);
    }
    return sum / (CENTERS * 2 * PI * scale * scale);
}

static double kuzmin(double x, double y, uint64_t seed)
{
    (void)seed;
    return pow(1 + x * x + y * y, -1.5) / (2 * PI);
}

static double log_normal(double x, double y, uint64_t seed)
{
    const double scale = 2, u = log(x) / scale, v = log(y) / scale;
    (void)seed;
    return exp(-(u * u + v * v) / 2) / (2 * PI * scale * scale * x * y);
}

typedef double density(double x, double y, uint64_t seed);

static const struct {
    const char *kind;
    density *density;
} known[] = {{"uniform", uniform},
             {"clustered", clustered},
             {"kuzmin", kuzmin},
             {"log-normal", log_normal}};

static density *density_of(const char *kind)
{
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (strcmp(known[k].kind, kind) == 0)
            return known[k].density;
    return NULL;
}

// ---- sums ----------------------------------------------------------
// What the points of a cell are compared with, if it has so many, each
// with so many others.
static double distances(double points, double others)
{
    return points * (22 + 9 * others);
}

static double from_counts(const struct piece *piece)
{
    const uint32_t *start = piece->sorted.cells.start;
    double sum = 0;
    for (uint32_t k = 0; k < grid_cells(&piece->sorted.grid); k++) {
        const double count = start[k + 1] - start[k];
        sum += distances(count, count - 1);
    }
    return sum;
}

static double middle(const struct axis *axis, uint32_t k)
{
    return (axis->border[k] + axis->border[k + 1]) / 2;
}

static double length(const struct axis *axis, uint32_t k)
{
    return axis->border[k + 1] - axis->border[k];
}

static double from_density(const struct piece *piece, uint32_t n,
                           density *density, uint64_t seed)
{
    const struct axis *x = &piece->sorted.grid.x;
    const struct axis *y = &piece->sorted.grid.y;
    double sum = 0;
    for (uint32_t row = 0; row < y->count; row++)
        for (uint32_t column = 0; column < x->count; column++) {
            const double count =
                n * length(x, column) * length(y, row) *
                density(middle(x, column), middle(y, row), seed);
            sum += distances(count, count);
        }
    return sum;
}

// All pieces, by counts if there is no density; a point in one place
// with others has its answer from the first of them.
static double sum_of(const struct pieces *pieces, density *density,
                     uint64_t seed)
{
    const uint32_t n = pieces->sorted.points.n;
    double sum = 0;
    for (uint32_t k = 0; k < pieces->leaves; k++)
        for (uint32_t i = 0; i < pieces->count[k]; i++) {
            const struct piece *piece =
                &pieces->piece[pieces->first[k] + i];
            sum += piece->is_place ? piece->sorted.points.n
                   : density ? from_density(piece, n, density, seed)
                             : from_counts(piece);
        }
    return sum / n;
}

double predict_from_counts(const struct pieces *pieces)
{
    return sum_of(pieces, NULL, 0);
}

double predict_from_density(const struct pieces *pieces,
                            const char *kind, uint64_t seed)
{
    density *density = density_of(kind);
    return density ? sum_of(pieces, density, seed) : NAN;
}
