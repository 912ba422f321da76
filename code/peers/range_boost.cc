// Boost.Geometry's R-tree, packed, in two and three dimensions. One
// type for each dimension, made from a template.
#include "peers/range_asked.h"
#define BOOST_ALLOW_DEPRECATED_HEADERS // its own use of them
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <utility>
#include <vector>

namespace
{
namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

template <int D> struct built : asked {
    using place = bg::model::point<double, D, bg::cs::cartesian>;
    using numbered = std::pair<place, uint32_t>;
    using box = bg::model::box<place>;
    std::vector<numbered> points;
    bgi::rtree<numbered, bgi::linear<16>> index;

    static place place_at(const double *x)
    {
        place p;
        bg::set<0>(p, x[0]);
        bg::set<1>(p, x[1]);
        if constexpr (D > 2)
            bg::set<2>(p, x[2]);
        return p;
    }

    built(const double *point, uint32_t n)
    {
        points.reserve(n);
        for (uint32_t i = 0; i < n; i++)
            points.push_back({place_at(point + (size_t)D * i), i});
        index = decltype(index)(points); // all at once
    }

    void nearest(uint32_t k, uint32_t *to, double *to2) override
    {
        std::vector<std::pair<double, uint32_t>> found;
        for (const numbered &query : points) {
            found.clear();
            for (auto it =
                     index.qbegin(bgi::nearest(query.first, k + 1));
                 it != index.qend(); ++it)
                if (it->second != query.second)
                    found.push_back({bg::comparable_distance(
                                         query.first, it->first),
                                     it->second});
            std::sort(found.begin(), found.end());
            for (uint32_t s = 0; s < k; s++) {
                to[(size_t)query.second * k + s] = found[s].second;
                to2[(size_t)query.second * k + s] = found[s].first;
            }
        }
    }

    // A box around the ball, and then the distance.
    uint64_t within(double distance) override
    {
        std::vector<numbered> found;
        uint64_t count = 0;
        for (const numbered &query : points) {
            double low[D], high[D];
            const double x[3] = {bg::get<0>(query.first),
                                 bg::get<1>(query.first),
                                 bg::get<D - 1>(query.first)};
            for (int k = 0; k < D; k++) {
                low[k] = x[k] - distance;
                high[k] = x[k] + distance;
            }
            found.clear();
            index.query(
                bgi::intersects(box(place_at(low), place_at(high))) &&
                    bgi::satisfies([&](const numbered &v) {
                        return bg::comparable_distance(v.first,
                                                       query.first) <=
                               distance * distance;
                    }),
                std::back_inserter(found));
            count += found.size();
        }
        return count;
    }

    uint64_t boxes(const double *row, uint32_t count) override
    {
        std::vector<numbered> found;
        uint64_t all = 0;
        for (uint32_t q = 0; q < count; q++, row += 2 * D) {
            found.clear();
            index.query(
                bgi::intersects(box(place_at(row), place_at(row + D))),
                std::back_inserter(found));
            all += found.size();
        }
        return all;
    }
};
} // namespace

const struct range_peer range_boost = {
    "boost-rtree", build<built>, nearest, within, boxes, discard};
