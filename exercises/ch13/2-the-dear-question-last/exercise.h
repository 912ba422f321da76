// Exercise: the dear question last
#pragma once
#include <stdbool.h>
#include <stdint.h>

// Whether two triangles share a point. Given; it counts.
bool triangles_meet(uint32_t t, uint32_t u);

struct pair {
    uint32_t one, other; // triangles, one < other
};

// Of so many candidates, sorted by one and then by other, perhaps with
// equal ones among them, leaves the contacts at the beginning: in the
// same order, each once. Returns how many. The nodes of triangle t are
// corner[t][0], corner[t][1] and corner[t][2].
uint32_t keep_contacts(struct pair *pair, uint32_t count,
                       const uint32_t (*corner)[3]);
