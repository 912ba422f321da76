//> Generate crowds
// Draws points that crowd. Sums, products, quotients and roots only, as
// in generate.c; so exp is a series here.
#include "common/generate_crowds.h"
#include "common/random.h"
#include <math.h>

//> Raise e to a complex power
// By its series, of a power that is a thousandth; then squared ten
// times.
struct complex {
    double x, y;
};

static struct complex times(struct complex a, struct complex b)
{
    return (struct complex){a.x * b.x - a.y * b.y,
                            a.x * b.y + a.y * b.x};
}

static struct complex exponential(double x, double y)
{
    const struct complex z = {x / 1024, y / 1024};
    struct complex sum = {1, 0}, term = {1, 0};
    for (int k = 1; k <= 12; k++) {
        term = times(term, z);
        term.x /= k;
        term.y /= k;
        sum.x += term.x;
        sum.y += term.y;
    }
    for (int k = 0; k < 10; k++)
        sum = times(sum, sum);
    return sum;
}
//<

//> Spread the points over many scales
void fill_log_normal(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = exponential(2 * random_normal(&random), 0).x;
        points.y[i] = exponential(2 * random_normal(&random), 0).x;
    }
}

void fill_pareto(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = 1 / (1 - random_uniform(&random));
        points.y[i] = 1 / (1 - random_uniform(&random));
    }
}

void fill_log_radius(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        double r = exponential(-20 * random_uniform(&random), 0).x;
        random_direction(&random, &points.x[i], &points.y[i]);
        points.x[i] *= r;
        points.y[i] *= r;
    }
}

// Twenty turns, each half as large as the one before.
void fill_spiral(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        const double turns = 20 * random_uniform(&random);
        const struct complex z = exponential(
            -0.6931471805599453 * turns, 6.283185307179586 * turns);
        points.x[i] = z.x;
        points.y[i] = z.y;
    }
}
//<

//> Crowd the points in few places
void fill_core_and_circle(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        double x, y;
        random_direction(&random, &x, &y);
        if (i % 2) {
            x = 0.001 * random_normal(&random);
            y = 0.001 * random_normal(&random);
        }
        points.x[i] = x;
        points.y[i] = y;
    }
}

// One of ten lives in the country.
void fill_towns(struct points points, uint64_t seed)
{
    enum { TOWNS = 100 };
    struct random random = {seed};
    double town[TOWNS][2];
    for (int k = 0; k < TOWNS; k++) {
        town[k][0] = random_uniform(&random);
        town[k][1] = random_uniform(&random);
    }
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = random_uniform(&random);
        points.y[i] = random_uniform(&random);
        if (i % 10) {
            const int k = random_bits(&random) % TOWNS;
            points.x[i] = town[k][0] + 0.0001 * random_normal(&random);
            points.y[i] = town[k][1] + 0.0001 * random_normal(&random);
        }
    }
}

void fill_half_equal(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = i % 2 ? 0.5 : random_uniform(&random);
        points.y[i] = i % 2 ? 0.5 : random_uniform(&random);
    }
}
//<

//> Spoil the scale
void fill_outlier(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = random_uniform(&random);
        points.y[i] = random_uniform(&random);
    }
    points.x[points.n - 1] = 1e9;
    points.y[points.n - 1] = 1e9;
}

void fill_thin(struct points points, uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = 1e-12 * random_uniform(&random);
        points.y[i] = random_uniform(&random);
    }
}

// Down to the last bit of a double; then again from 1 on.
void fill_geometric(struct points points, uint64_t seed)
{
    (void)seed;
    for (uint32_t i = 0; i < points.n; i++)
        points.x[i] = points.y[i] = ldexp(1, -(int)(i % 1075));
}

void fill_doubled(struct points points, uint64_t seed)
{
    (void)seed;
    const uint32_t side = (uint32_t)ceil(sqrt(points.n / 2.0));
    const double step = floor(0x1p32 / side) * 0x1p-32;
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = (i / 2 % side + 0.5) * step;
        points.y[i] = (i / 2 / side + 0.5) * step;
    }
}
//<
//<
