//> Declare the portable primitives
#pragma once
#include "ch06-pack-scan/primitives.h"

extern const struct primitives portable_primitives;
//<
