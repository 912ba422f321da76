// CGAL's k-d tree in two and three dimensions. The tree keeps the
// coordinates in the order of its leaves, as in cgal.cc.
#include "peers/range_asked.h"
#include <CGAL/Fuzzy_iso_box.h>
#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_2.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace
{
enum { LEAF = 32 }; // of 10, 16 and 32 the fastest in all

using kernel = CGAL::Simple_cartesian<double>;

template <int D> struct built : asked {
    using place =
        std::conditional_t<D == 2, kernel::Point_2, kernel::Point_3>;
    using space =
        std::conditional_t<D == 2, CGAL::Search_traits_2<kernel>,
                           CGAL::Search_traits_3<kernel>>;
    using numbered = std::pair<place, uint32_t>;
    using coordinates = CGAL::First_of_pair_property_map<numbered>;
    using traits =
        CGAL::Search_traits_adapter<numbered, coordinates, space>;
    using splitter = CGAL::Sliding_midpoint<traits>;
    using tree =
        CGAL::Kd_tree<traits, splitter, CGAL::Tag_true, CGAL::Tag_true>;
    using metric =
        CGAL::Distance_adapter<numbered, coordinates,
                               CGAL::Euclidean_distance<space>>;
    using search = CGAL::Orthogonal_k_neighbor_search<traits, metric,
                                                      splitter, tree>;
    std::vector<numbered> points;
    tree index;

    static place place_at(const double *x)
    {
        if constexpr (D == 2)
            return place(x[0], x[1]);
        else
            return place(x[0], x[1], x[2]);
    }

    built(const double *point, uint32_t n) : index(splitter(LEAF))
    {
        points.reserve(n);
        for (uint32_t i = 0; i < n; i++)
            points.push_back({place_at(point + (size_t)D * i), i});
        index.insert(points.begin(), points.end());
        index.build(); // now, and not when it is first asked
    }

    // One more, since the query finds itself.
    void nearest(uint32_t k, uint32_t *to, double *to2) override
    {
        for (const numbered &query : points) {
            const search found(index, query.first, k + 1);
            uint32_t t = 0;
            for (const auto &near : found)
                if (near.first.second != query.second && t < k) {
                    const size_t at = (size_t)query.second * k + t++;
                    to[at] = near.first.second;
                    to2[at] = near.second;
                }
        }
    }

    uint64_t within(double distance) override
    {
        std::vector<numbered> found;
        uint64_t count = 0;
        for (const numbered &query : points) {
            found.clear();
            index.search(
                std::back_inserter(found),
                CGAL::Fuzzy_sphere<traits>(query.first, distance));
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
            index.search(std::back_inserter(found),
                         CGAL::Fuzzy_iso_box<traits>(
                             place_at(row), place_at(row + D)));
            all += found.size();
        }
        return all;
    }
};
} // namespace

const struct range_peer range_cgal = {"CGAL", build<built>, nearest,
                                      within, boxes,        discard};
