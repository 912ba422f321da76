// A k-d tree of the Computational Geometry Algorithms Library
// (Tangelder and Fabri), for points of the plane in double precision,
// each with its number. The tree keeps the coordinates in the order of
// its leaves. TBB's threads build it, OpenMP's query it.
#include "peers/peer.h"
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <CGAL/version.h>
#include <utility>
#include <vector>

namespace
{
using kernel = CGAL::Simple_cartesian<double>;
using point = std::pair<kernel::Point_2, uint32_t>;
using plane = CGAL::Search_traits_2<kernel>;
using coordinates = CGAL::First_of_pair_property_map<point>;
using traits = CGAL::Search_traits_adapter<point, coordinates, plane>;
using splitter = CGAL::Sliding_midpoint<traits>;
using tree =
    CGAL::Kd_tree<traits, splitter, CGAL::Tag_true, CGAL::Tag_true>;
using metric = CGAL::Distance_adapter<point, coordinates,
                                      CGAL::Euclidean_distance<plane>>;
using search =
    CGAL::Orthogonal_k_neighbor_search<traits, metric, splitter, tree>;

struct built {
    const place *from;
    uint32_t n;
    tree index;
};

void *build(const place *from, uint32_t n, int leaf_size, int threads)
{
    std::vector<point> points(n);
    for (uint32_t i = 0; i < n; i++)
        points[i] = {{from[i][0], from[i][1]}, i};
    built *made = new built{
        from, n, {points.begin(), points.end(), splitter(leaf_size)}};
    if (threads > 1)
        made->index.build<CGAL::Parallel_tag>();
    else
        made->index.build();
    return made;
}

// The two nearest, one of which is the point itself, unless others are
// in the same place: then any other is at the right distance.
void query(void *made, int threads, uint32_t *nearest, double *nearest2)
{
    const built &here = *static_cast<built *>(made);
#pragma omp parallel for num_threads(threads)
    for (uint32_t i = 0; i < here.n; i++) {
        kernel::Point_2 place(here.from[i][0], here.from[i][1]);
        search two(here.index, place, 2, 0, true, metric(), false);
        auto best = two.begin();
        if (best->first.second == i)
            ++best;
        nearest[i] = best->first.second;
        nearest2[i] = best->second;
    }
}

void discard(void *made)
{
    delete static_cast<built *>(made);
}
} // namespace

const struct peer peer_cgal = {
    "CGAL", CGAL_VERSION_STR, {4, 8, 16, 32}, true, build,
    query,  discard};
