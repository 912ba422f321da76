// A k-d tree in one header (Blanco and Rai, 2014), made for two
// dimensions by its templates. Its search takes any receiver of points
// that has the functions below; ours keeps the best and refuses the
// query itself, which costs less than the two nearest and is as
// exact.
#include "peers/nanoflann_cloud.h"
#include "peers/peer.h"
#include <limits>
#include <nanoflann.hpp>

namespace
{
//> Receive every point but one
struct receiver {
    uint32_t self, nearest;
    double best2 = std::numeric_limits<double>::infinity();

    bool addPoint(double distance2, uint32_t i)
    {
        if (i != self && distance2 < best2) {
            best2 = distance2;
            nearest = i;
        }
        return true; // go on
    }
    double worstDist() const
    {
        return best2;
    }
    bool full() const
    {
        return true;
    }
};
//<

using tree = nanoflann::KDTreeSingleIndexAdaptor<
    nanoflann::L2_Simple_Adaptor<double, cloud<2>>, cloud<2>, 2>;

struct built {
    cloud<2> points;
    tree index;

    built(const place *point, uint32_t n, size_t leaf_size)
        : points{&point[0][0], n}, index(2, points, {leaf_size})
    {
        index.buildIndex();
    }
};

void *build(const place *point, uint32_t n, int leaf_size, int)
{
    return new built(point, n, leaf_size);
}

//> Let nanoflann answer
void query(void *made, int threads, uint32_t *nearest, double *nearest2)
{
    const built &here = *static_cast<built *>(made);
#pragma omp parallel for num_threads(threads)
    for (uint32_t i = 0; i < here.points.n; i++) {
        receiver best = {i, i};
        here.index.findNeighbors(best,
                                 here.points.point + 2 * (size_t)i, {});
        nearest[i] = best.nearest;
        nearest2[i] = best.best2;
    }
}
//<

void discard(void *made)
{
    delete static_cast<built *>(made);
}
} // namespace

static const char version[] = {'0' + (NANOFLANN_VERSION >> 8),      '.',
                               '0' + (NANOFLANN_VERSION >> 4 & 15), '.',
                               '0' + (NANOFLANN_VERSION & 15),      0};

const struct peer peer_nanoflann = {
    "nanoflann", version, {8, 16, 32, 64}, true, build, query, discard};
