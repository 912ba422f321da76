// The points of nanoflann's trees: rows of D coordinates that stay
// where they are. It asks for their number and for one coordinate at a
// time.
#pragma once
#include <cstddef>
#include <cstdint>

template <int D> struct cloud {
    const double *point;
    uint32_t n;

    size_t kdtree_get_point_count() const
    {
        return n;
    }
    double kdtree_get_pt(size_t i, size_t axis) const
    {
        return point[D * i + axis];
    }
    template <class Box> bool kdtree_get_bbox(Box &) const
    {
        return false; // let it look for itself
    }
};
