// Exercise: as bad as can be
#pragma once
#include "common/points.h"

// Sets x and y of all points to whole numbers from 0 to side, so that
// the hull has as many corners as possible. side >= 10, and there are
// more points than the hull can have corners.
void worst_case(struct points points, uint32_t side);
