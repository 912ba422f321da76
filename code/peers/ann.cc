// The library of Arya and Mount. It is compiled already, for any
// dimension. A search keeps its state in global variables, so that only
// one may run at a time.
#include "peers/peer.h"
#include <ANN/ANN.h>
#include <utility>
#include <vector>

namespace
{
struct built {
    std::vector<ANNpoint> points; // where each is
    ANNkd_tree index;

    built(std::vector<ANNpoint> &&where, int leaf_size)
        : points(std::move(where)), index(points.data(), points.size(),
                                          2, leaf_size, ANN_KD_SUGGEST)
    {
    }
};

void *build(const place *point, uint32_t n, int leaf_size, int)
{
    std::vector<ANNpoint> points(n);
    for (uint32_t i = 0; i < n; i++)
        points[i] = const_cast<ANNpoint>(point[i]);
    return new built(std::move(points), leaf_size);
}

void query(void *made, int, uint32_t *nearest, double *nearest2)
{
    built &here = *static_cast<built *>(made);
    const ANNidx n = here.points.size();
    for (ANNidx i = 0; i < n; i++) {
        ANNidx two[2];
        ANNdist distance2[2];
        here.index.annkSearch(here.points[i], 2, two, distance2);
        int best = two[0] == i;
        nearest[i] = two[best];
        nearest2[i] = distance2[best];
    }
}

void discard(void *made)
{
    delete static_cast<built *>(made);
}
} // namespace

const struct peer peer_ann = {"ANN", ANNversion, {4, 8, 16, 32}, false,
                              build, query,      discard};
