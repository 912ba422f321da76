//> Declare sweep and prune
// Along each of three axes all ends of boxes in order, and the pairs
// that meet; both are kept from step to step. Where an end passes
// another one, a pair may begin to meet or cease to: what does not
// change costs nothing (Baraff 1992; Cohen, Lin, Manocha and Ponamgi
// 1995).
#pragma once
#include "ch13-contact/broad_phase.h"

// One thread works. Groups must stay as they are as long as their
// array, and the number of boxes, are the same.
void *begin_sweep_and_prune(const struct broad_phase *phase);
void find_by_sweep_and_prune(void *kept,
                             const struct broad_search *search);
void end_sweep_and_prune(void *kept);
//<
