//> Decide orientations exactly
// First in floating point, with a bound on what rounding may have done.
// If the determinant is no larger than that, it is computed again as an
// expansion: a sum of doubles, largest last, that do not overlap, so
// that the last alone has the sign of all. (Shewchuk 1997.)
#include "ch13-contact/exact.h"
#include <assert.h>
#include <float.h>
#include <math.h>

static_assert(FLT_EVAL_METHOD == 0, "a double is rounded as a double");

//> Check that coordinates can be decided
bool within_exact_bounds(const double *x, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        const double size = fabs(x[k]);
        if (!(size == 0 || (size >= MIN_EXACT && size <= MAX_EXACT)))
            return false;
    }
    return true;
}
//<

//> Add and multiply without loss
// A result, rounded, and what rounding took away: head + tail is exact.
// (Knuth's sum, in Dekker 1971; the product by a fused operation.)
struct exact_pair {
    double head, tail;
};

static struct exact_pair exact_sum(double a, double b)
{
    const double head = a + b, of_b = head - a;
    return (struct exact_pair){head, (a - (head - of_b)) + (b - of_b)};
}

static struct exact_pair exact_product(double a, double b)
{
    const double head = a * b;
    return (struct exact_pair){head, fma(a, b, -head)};
}
//<

//> Keep a sum in parts
// Parts do not overlap: each is a multiple of a power of two that is
// larger than what all parts before it sum to. None is 0.
enum { MAX_PARTS = 6 * 8 * 4 }; // products, of two parts each, fourfold
struct expansion {
    int n;
    double part[MAX_PARTS];
};
//<

//> Hold a sum without rounding
// Adds x: what it loses on its way through the parts takes their place.
static void expansion_add(struct expansion *e, double x)
{
    int n = 0;
    for (int k = 0; k < e->n; k++) {
        const struct exact_pair sum = exact_sum(x, e->part[k]);
        if (sum.tail != 0)
            e->part[n++] = sum.tail;
        x = sum.head;
    }
    if (x != 0)
        e->part[n++] = x;
    e->n = n;
}

static int expansion_sign(const struct expansion *e)
{
    if (e->n == 0)
        return 0;
    return e->part[e->n - 1] > 0 ? 1 : -1;
}
//<

//> Add a product of differences
// Adds r s t: each is a head and a tail, so eight products, each of
// four parts.
static void expansion_add_product(struct expansion *e,
                                  struct exact_pair r,
                                  struct exact_pair s,
                                  struct exact_pair t)
{
    for (int k = 0; k < 8; k++) {
        const double x = k & 1 ? r.tail : r.head;
        const double y = k & 2 ? s.tail : s.head;
        const double z = k & 4 ? t.tail : t.head;
        if (x == 0 || y == 0 || z == 0)
            continue;
        const struct exact_pair xy = exact_product(x, y);
        const struct exact_pair high = exact_product(xy.head, z);
        const struct exact_pair low = exact_product(xy.tail, z);
        expansion_add(e, low.tail);
        expansion_add(e, low.head);
        expansion_add(e, high.tail);
        expansion_add(e, high.head);
    }
}
//<

//> Decide in space with expansions
static int expanded_orientation3(const double *a, const double *b,
                                 const double *c, const double *d)
{
    struct exact_pair r[3], s[3], t[3], minus[3];
    for (int k = 0; k < 3; k++) {
        r[k] = exact_sum(b[k], -a[k]);
        s[k] = exact_sum(c[k], -a[k]);
        t[k] = exact_sum(d[k], -a[k]);
        minus[k] = (struct exact_pair){-t[k].head, -t[k].tail};
    }
    struct expansion e = {0};
    for (int x = 0; x < 3; x++) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        expansion_add_product(&e, r[x], s[y], t[z]);
        expansion_add_product(&e, r[x], s[z], minus[y]);
    }
    return expansion_sign(&e);
}
//<

//> Decide in space
// With u = 2^-53, an operation gives its exact result times 1 + h with
// |h| <= u. The determinant is a sum of six products of three
// differences. Each goes through eight roundings at most: of three
// differences, of a product, of a difference, of a product, and of two
// sums. So it counts in the result with an error below 8 u of itself,
// to first order in u, and all errors sum to less than 8 u times the
// sum of the six sizes. This sum is computed, too, as size, with no
// more roundings; a ninth u has room for them, for all higher orders
// and for the last product here.
int orientation3(const double a[3], const double b[3],
                 const double c[3], const double d[3],
                 uint64_t *expanded)
{
    const double r[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double s[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const double t[3] = {d[0] - a[0], d[1] - a[1], d[2] - a[2]};
    const double yz = s[1] * t[2], zy = s[2] * t[1];
    const double zx = s[2] * t[0], xz = s[0] * t[2];
    const double xy = s[0] * t[1], yx = s[1] * t[0];
    const double determinant =
        r[0] * (yz - zy) + r[1] * (zx - xz) + r[2] * (xy - yx);
    const double size = fabs(r[0]) * (fabs(yz) + fabs(zy)) +
                        fabs(r[1]) * (fabs(zx) + fabs(xz)) +
                        fabs(r[2]) * (fabs(xy) + fabs(yx));
    const double error = 9 * 0x1p-53 * size;
    if (fabs(determinant) > error)
        return determinant > 0 ? 1 : -1;
    assert(within_exact_bounds(a, 3) && within_exact_bounds(b, 3) &&
           within_exact_bounds(c, 3) && within_exact_bounds(d, 3));
    if (size == 0)
        return 0;
    if (expanded)
        (*expanded)++;
    return expanded_orientation3(a, b, c, d);
}
//<

//> Decide in a plane
// The same with two products of two differences: four roundings each,
// and a fifth u for the rest.
int orientation2(const double a[2], const double b[2],
                 const double c[2], uint64_t *expanded)
{
    const double left = (b[0] - a[0]) * (c[1] - a[1]);
    const double right = (b[1] - a[1]) * (c[0] - a[0]);
    const double determinant = left - right;
    const double size = fabs(left) + fabs(right);
    const double error = 5 * 0x1p-53 * size;
    if (fabs(determinant) > error)
        return determinant > 0 ? 1 : -1;
    assert(within_exact_bounds(a, 2) && within_exact_bounds(b, 2) &&
           within_exact_bounds(c, 2));
    if (size == 0)
        return 0;
    if (expanded)
        (*expanded)++;
    const struct exact_pair one = {1, 0}, minus_one = {-1, 0};
    struct expansion e = {0};
    expansion_add_product(&e, exact_sum(b[0], -a[0]),
                          exact_sum(c[1], -a[1]), one);
    expansion_add_product(&e, exact_sum(b[1], -a[1]),
                          exact_sum(c[0], -a[0]), minus_one);
    return expansion_sign(&e);
}
//<
//<
