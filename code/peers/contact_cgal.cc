// CGAL's intersection of boxes, by streamed segment trees (Zomorodian
// and Edelsbrunner 2002).
#include "peers/broad_phase_peer.h"
#include <CGAL/box_intersection_d.h>
#include <utility>
#include <vector>

namespace
{
using box = CGAL::Box_intersection_d::Box_d<
    double, 3, CGAL::Box_intersection_d::ID_EXPLICIT>;

struct numbered : box {
    uint32_t number;
    numbered(const double *row, uint32_t number)
        : box(const_cast<double *>(row), const_cast<double *>(row + 3)),
          number(number)
    {
    }
};

struct kept {
    uint32_t n;
    std::vector<numbered> boxes;
    std::vector<std::pair<uint32_t, uint32_t>> pairs;
};

void *begin(const double *, uint32_t n)
{
    return new kept{n, {}, {}};
}

uint64_t find(void *made, const double *row)
{
    kept *k = static_cast<kept *>(made);
    k->boxes.clear();
    k->pairs.clear();
    for (uint32_t i = 0; i < k->n; i++)
        k->boxes.emplace_back(row + 6 * (size_t)i, i);
    CGAL::box_self_intersection_d(
        k->boxes.begin(), k->boxes.end(),
        [&](const numbered &a, const numbered &b) {
            k->pairs.emplace_back(a.number, b.number);
        });
    return k->pairs.size();
}

void end(void *made)
{
    delete static_cast<kept *>(made);
}
} // namespace

const struct broad_phase_peer contact_cgal = {"cgal-boxes", begin, find,
                                              end,          0,     0};
