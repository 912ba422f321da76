//> Generate points
// Like the random numbers themselves, the points are
// made by sums, products, quotients and roots only, so that they are
// the same to the last bit on every machine.
#include "common/generate.h"
#include "common/generate_crowds.h"
#include "common/random.h"
#include <math.h>
#include <string.h>

//> Fill the unit square evenly
static void uniform(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = random_uniform(&random);
        points.y[i] = random_uniform(&random);
    }
}
//<

//> Gather the points around centers
// Each point is a normal offset away from a center chosen at random.
static void gather(struct points points, struct random *random,
                   double (*centers)[2], int count, double scale)
{
    for (uint32_t i = 0; i < points.n; i++) {
        int center = (int)(count * random_uniform(random));
        points.x[i] =
            centers[center][0] + scale * random_normal(random);
        points.y[i] =
            centers[center][1] + scale * random_normal(random);
    }
}
//<

//> Choose the centers
static void clustered(struct points points, uint64_t seed)
{
    struct random random = {seed};
    double centers[10][2];
    for (int c = 0; c < 10; c++)
        for (int axis = 0; axis < 2; axis++)
            centers[c][axis] = random_uniform(&random);
    gather(points, &random, centers, 10, 0.1);
}

static void two_clusters(struct points points, uint64_t seed)
{
    struct random random = {seed};
    double centers[2][2] = {{0.1, 0.1}, {0.9, 0.9}};
    gather(points, &random, centers, 2, 0.001);
}
//<

//> Set the points on a lattice
// The step is a multiple of a power of two: then all coordinates and
// their differences are exact, so that points as many columns and as
// many rows away tie. The seed has no say in it.
static void lattice(struct points points, uint64_t seed)
{
    (void)seed;
    uint32_t side = (uint32_t)ceil(sqrt(points.n));
    double step = floor(0x1p32 / side) * 0x1p-32;
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = (i % side + 0.5) * step;
        points.y[i] = (i / side + 0.5) * step;
    }
}
//<

//> Set the points on a circle
static void circle(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        double x, y;
        random_direction(&random, &x, &y);
        points.x[i] = 0.5 + 0.5 * x;
        points.y[i] = 0.5 + 0.5 * y;
    }
}
//<

//> Spread the points like the stars of a flat galaxy
// Kuzmin's disc (1956; Toomre 1963): the share 1 - 1/sqrt(1 + r^2) of
// all mass lies within r. Solved for r, it turns a uniform number into
// a radius. Half of the points lie within sqrt(3), a few very far out.
static void kuzmin(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        double outside = 1 - random_uniform(&random);
        double r = sqrt(1 / (outside * outside) - 1), x, y;
        random_direction(&random, &x, &y);
        points.x[i] = r * x;
        points.y[i] = r * y;
    }
}
//<

//> Leave out a dimension, or two
static void equal(struct points points, uint64_t seed)
{
    struct random random = {seed};
    double x = random_uniform(&random), y = random_uniform(&random);
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = x;
        points.y[i] = y;
    }
}

static void collinear(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = random_uniform(&random);
        points.y[i] = 0.25 + 0.5 * points.x[i];
    }
}
//<

//> Name the generators
const struct distribution distributions[] = {
    {"uniform", "evenly in the unit square", uniform},
    {"clustered", "ten normal clusters, scale 0.1 (Su)", clustered},
    {"lattice", "a square grid that fills the unit square", lattice},
    {"circle", "on the circle inside the unit square", circle},
    {"kuzmin", "Kuzmin's disc: dense center, far outskirts", kuzmin},
    {"two-clusters", "two small clusters, far apart", two_clusters},
    {"equal", "all in the same place", equal},
    {"collinear", "on one slanted line", collinear},
    {"log-normal", "both coordinates exp of 2 normals",
     fill_log_normal},
    {"pareto", "both coordinates 1 / uniform", fill_pareto},
    {"log-radius", "a disc, log of the radius even", fill_log_radius},
    {"spiral", "on a logarithmic spiral, 20 turns", fill_spiral},
    {"core-and-circle", "half in a dense core, half around it",
     fill_core_and_circle},
    {"towns", "a hundred dense towns on an empty plain", fill_towns},
    {"half-equal", "every other one in the same place",
     fill_half_equal},
    {"outlier", "uniform, but the last is at 1e9", fill_outlier},
    {"thin", "uniform, but x is 1e-12 wide", fill_thin},
    {"geometric", "2^-k on both axes, k to 1074, and again",
     fill_geometric},
    {"doubled", "a lattice, each place twice", fill_doubled},
};
const int distribution_count =
    sizeof distributions / sizeof *distributions;
//<

//> Find a generator by its name
const struct distribution *find_distribution(const char *name)
{
    for (int row = 0; row < distribution_count; row++)
        if (strcmp(distributions[row].name, name) == 0)
            return &distributions[row];
    return NULL;
}

struct points generate(const struct distribution *distribution,
                       uint32_t n, uint64_t seed)
{
    struct points points = points_allocate(n);
    distribution->fill(points, seed);
    return points;
}
//<
//<
