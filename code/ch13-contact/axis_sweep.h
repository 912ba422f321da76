//> Declare the sweep along an axis
// Boxes in the order of their low ends along one axis. From each, the
// boxes that follow are looked at, up to the first that begins behind
// its end (Baraff 1992).
#pragma once
#include "ch13-contact/broad_phase.h"

// With the order sorted anew in each step, or kept and repaired by
// insertion, as things that move little leave it almost sorted.
void *begin_sweep(const struct broad_phase *phase);
void *begin_sweep_kept(const struct broad_phase *phase);
void find_by_sweep(void *kept, const struct broad_search *search);
void end_sweep(void *kept);
//<
