//> Declare the broad phase by a structure
// Chapter 12 finds points in boxes. Here the point of a triangle is the
// low corner of its box, and its query is its box, enlarged downwards
// by the greatest width that a box has: what meets the box has its low
// corner there. Where widths differ, so that one giant would enlarge
// all queries, boxes are parted into classes of size.
#pragma once
#include "ch13-contact/broad_phase.h"

void *begin_structure(const struct broad_phase *phase);
void find_by_structure(void *kept, const struct broad_search *search);
void end_structure(void *kept);
//<
