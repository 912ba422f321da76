// The library of Muja and Lowe, known for approximate answers in many
// dimensions; for few and exact ones it has a single k-d tree, which
// copies the points in the order of its leaves. It queries all points
// by itself, threads included.
#include "peers/peer.h"
#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>
#include <flann/config.h>
#include <vector>

namespace
{
using metric = flann::L2_Simple<double>;
using tree = flann::KDTreeSingleIndex<metric>;

struct built {
    flann::Matrix<double> points;
    tree index;
    std::vector<size_t> two;
    std::vector<double> distance2;
};

void *build(const place *point, uint32_t n, int leaf_size, int)
{
    flann::Matrix<double> points(const_cast<double *>(point[0]), n, 2);
    flann::KDTreeSingleIndexParams parameters(leaf_size);
    built *made = new built{points, {points, parameters}, {}, {}};
    made->index.buildIndex();
    return made;
}

void query(void *made, int threads, uint32_t *nearest, double *nearest2)
{
    built &here = *static_cast<built *>(made);
    const size_t n = here.points.rows;
    here.two.resize(2 * n);
    here.distance2.resize(2 * n);
    flann::Matrix<size_t> two(here.two.data(), n, 2);
    flann::Matrix<double> distance2(here.distance2.data(), n, 2);
    flann::SearchParams exact(flann::FLANN_CHECKS_UNLIMITED, 0);
    exact.cores = threads;
    here.index.knnSearch(here.points, two, distance2, 2, exact);
    for (size_t i = 0; i < n; i++) {
        int best = two[i][0] == i;
        nearest[i] = two[i][best];
        nearest2[i] = distance2[i][best];
    }
}

void discard(void *made)
{
    delete static_cast<built *>(made);
}
} // namespace

const struct peer peer_flann = {"FLANN", FLANN_VERSION_, {4, 8, 16, 32},
                                true,    build,          query,
                                discard};
