// A library by others that finds the boxes that meet, behind a few
// functions, so that all are used alike. A box is a row of three lows
// and three highs.
#pragma once
#include <stdint.h>

struct broad_phase_peer {
    const char *name;
    // What it keeps from step to step, of n boxes.
    void *(*begin)(const double *box, uint32_t n);
    // The boxes have moved; how many pairs meet, each put into a list.
    uint64_t (*find)(void *kept, const double *box);
    void (*end)(void *kept);
    int is_wide; // it may report pairs that only nearly meet
    int is_slow; // to begin with: its time grows with the square of n
};

#ifdef __cplusplus
extern "C" {
#endif
extern const struct broad_phase_peer contact_cgal, contact_dbvt,
    contact_sap;
#ifdef __cplusplus
}
#endif
