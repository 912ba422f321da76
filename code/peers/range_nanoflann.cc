// nanoflann's k-d tree in two and three dimensions: one type for each,
// made from a template.
#include "peers/nanoflann_cloud.h"
#include "peers/range_asked.h"
#include <nanoflann.hpp>
#include <utility>
#include <vector>

namespace
{
enum { LEAF = 16 }; // of 10, 16 and 32 the fastest in all

template <int D> struct built : asked {
    using tree = nanoflann::KDTreeSingleIndexAdaptor<
        nanoflann::L2_Simple_Adaptor<double, cloud<D>>, cloud<D>, D,
        uint32_t>;
    cloud<D> points;
    tree index;

    built(const double *point, uint32_t n)
        : points{point, n}, index(D, points, {LEAF})
    {
        index.buildIndex();
    }

    // One more, since the query finds itself.
    void nearest(uint32_t k, uint32_t *to, double *to2) override
    {
        std::vector<uint32_t> found(k + 1);
        std::vector<double> found2(k + 1);
        for (uint32_t i = 0; i < points.n; i++) {
            index.knnSearch(points.point + (size_t)D * i, k + 1,
                            found.data(), found2.data());
            for (uint32_t s = 0, t = 0; s <= k && t < k; s++)
                if (found[s] != i) {
                    to[(size_t)i * k + t] = found[s];
                    to2[(size_t)i * k + t++] = found2[s];
                }
        }
    }

    uint64_t within(double distance) override
    {
        std::vector<std::pair<uint32_t, double>> found;
        nanoflann::SearchParams unsorted;
        unsorted.sorted = false;
        uint64_t count = 0;
        for (uint32_t i = 0; i < points.n; i++)
            count += index.radiusSearch(points.point + (size_t)D * i,
                                        distance * distance, found,
                                        unsorted);
        return count;
    }
};
} // namespace

const struct range_peer range_nanoflann = {
    "nanoflann", build<built>, nearest, within, nullptr, discard};
