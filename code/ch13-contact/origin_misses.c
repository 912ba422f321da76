//> Prove that a polygon misses the origin
// Three proofs that a polygon in motion does not meet the origin, each
// of some hundred operations at most, each with an allowance for what
// rounding may have done. With u = 2^-53 and the size M, places are
// wrong by 160 u M at most: by u M from their subtraction, and by as
// much from each of up to 135 halvings.
#include "ch13-contact/origin_search.h"
#include "ch13-contact/vectors.h"
#include "common/min_max.h"

//> Bound what rounding spoils
double polygon_size(const struct moving_polygon *polygon)
{
    double size = 0;
    for (int k = 0; k < polygon->corners; k++)
        for (int end = 0; end < 2; end++) {
            const double here = largest(polygon->corner[k].place[end]);
            size = MAX(size, here);
        }
    return size;
}

double rounding_allowance(double size)
{
    return 256 * 0x1p-53 * size;
}
//<

//> Prove it by a plane through the origin
// Corners move straight, so what the polygon passes over lies in the
// hull of its corners' first and last places. If n v > 0 for all these
// v, the origin is not in it. An n v is wrong by what v is, at most
// 160 u M |n| with |n| the sum of sizes, and by its own five roundings,
// at most 4 u M |n|: less than 256 u M |n| in all. Any n will do,
// except one so short that products vanish.
bool missed_by_plane(const struct moving_polygon *polygon,
                     const double n[3], double allowance)
{
    const double length = fabs(n[0]) + fabs(n[1]) + fabs(n[2]);
    double min = INFINITY, max = -INFINITY;
    for (int k = 0; k < polygon->corners; k++)
        for (int end = 0; end < 2; end++) {
            const double side = dot(n, polygon->corner[k].place[end]);
            min = MIN(min, side);
            max = MAX(max, side);
        }
    return length > 0x1p-600 &&
           (min > allowance * length || max < -allowance * length);
}

// Of the three planes of coordinates, n v is a coordinate of v.
bool missed_by_box(const struct moving_polygon *polygon,
                   double allowance)
{
    bool beside = false;
    for (int x = 0; x < 3; x++) {
        double min = INFINITY, max = -INFINITY;
        for (int k = 0; k < polygon->corners; k++)
            for (int end = 0; end < 2; end++) {
                min = MIN(min, polygon->corner[k].place[end][x]);
                max = MAX(max, polygon->corner[k].place[end][x]);
            }
        beside |= min > allowance || max < -allowance;
    }
    return beside;
}
//<

//> Mix a determinant of two times
// Of two sides of the polygon and a corner, each at its own end of the
// motion: (bit 0, bit 1, bit 2) of ends.
static double mixed_determinant(const struct moving_polygon *polygon,
                                int ends)
{
    const int last = polygon->corners - 1;
    const int i = ends & 1, j = ends >> 1 & 1, k = ends >> 2;
    double one[3], other[3], product[3];
    subtract(polygon->corner[1].place[i], polygon->corner[0].place[i],
             one);
    subtract(polygon->corner[last].place[j],
             polygon->corner[0].place[j], other);
    cross(one, other, product);
    return dot(product, polygon->corner[0].place[k]);
}
//<

//> Prove it by four coefficients
// The volume that two sides and a corner span is 0 when the plane
// passes over the origin. It is a cubic in time, in Bernstein's form
//     b0 (1-t)^3 + b1 3 t (1-t)^2 + b2 3 t^2 (1-t) + b3 t^3,
// and if its four coefficients have one sign, so has it. b0 and b3 are
// determinants of the beginning and of the end, 3 b1 and 3 b2 sums of
// three that mix both. Each determinant is a sum of six products of
// 2 M, 2 M and M at most. With places wrong by u M, a side is wrong by
// 4 u M, a product by 8 u M^3 for either side, 4 u M^3 for the corner,
// and 4 u M^3 for each of at most five roundings: by 40 u M^3, and six
// of them by 240 u M^3. Three such sums and two roundings more, of at
// most 72 u M^3 each, make 864 u M^3; we allow for 2048.
bool missed_by_signs(const struct moving_polygon *polygon, double size)
{
    double sum[4] = {0};
    for (int ends = 0; ends < 8; ends++) {
        const int late = (ends & 1) + (ends >> 1 & 1) + (ends >> 2);
        sum[late] += mixed_determinant(polygon, ends);
    }
    const double error = 2048 * 0x1p-53 * size * size * size;
    const double min = fmin(fmin(sum[0], sum[1]), fmin(sum[2], sum[3]));
    const double max = fmax(fmax(sum[0], sum[1]), fmax(sum[2], sum[3]));
    return min > error || max < -error;
}
//<
//<
