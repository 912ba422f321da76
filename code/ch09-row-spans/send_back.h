//> Declare the way back
// Who asks in the order of the cells has his answers in that order, and
// they are wanted in the order of the input. So they go back in the
// parcels in which the points came: into the parcels of a band, which
// fit a cache, and then to the senders, who find theirs in streams, one
// for each band.
#pragma once
#include "ch09-row-spans/carry.h"

//> Pack an answer for the way back
struct finding {
    double d2;
    uint32_t who;
};
//<

// A parcel for each point; NULL: that half is not asked for.
struct findings {
    struct finding *nearest, *furthest;
};

// Room for what the answers have arrays for, n points. Released with
// findings_free.
struct findings findings_for(const struct answers *answers, uint32_t n);
void findings_free(struct findings *findings);

// Packs the answers for the sorted points begin .. end - 1, the first
// of them at place 0 of found. Different threads may pack different
// points.
void findings_pack(const struct carried *carried, uint32_t begin,
                   uint32_t end, const struct answers *found,
                   const struct findings *findings);

// Sends all back, by so many threads.
void findings_send_back(const struct carried *carried,
                        const struct findings *findings, int threads,
                        struct answers *answers);
//<
