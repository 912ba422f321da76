// What the structures of libraries in C++ have in common: one class for
// each number of dimensions, built<D>, behind the functions of
// range_peer.h.
#pragma once
#include "peers/range_peer.h"

namespace
{
struct asked {
    virtual ~asked() = default;
    virtual void nearest(uint32_t k, uint32_t *to, double *to2) = 0;
    virtual uint64_t within(double distance) = 0;
    virtual uint64_t boxes(const double *, uint32_t)
    {
        return 0; // it has none
    }
};

template <template <int> class built>
void *build(const double *point, uint32_t n, int d)
{
    asked *made = nullptr;
    if (d == 2)
        made = new built<2>(point, n);
    else
        made = new built<3>(point, n);
    return made;
}

void nearest(void *made, uint32_t k, uint32_t *to, double *to2)
{
    static_cast<asked *>(made)->nearest(k, to, to2);
}

uint64_t within(void *made, double distance)
{
    return static_cast<asked *>(made)->within(distance);
}

[[maybe_unused]] uint64_t boxes(void *made, const double *box,
                                uint32_t count)
{
    return static_cast<asked *>(made)->boxes(box, count);
}

void discard(void *made)
{
    delete static_cast<asked *>(made);
}
} // namespace
