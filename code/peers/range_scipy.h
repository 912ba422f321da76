// SciPy's k-d tree among the others. It runs in a Python of its own,
// $PYTHON or python3, which gets the points and gives its answers back
// in files, on no clock; the program must run in the folder that has
// code/ in it.
#pragma once
#include "peers/range_scene.h"
#include <stdbool.h>

// Whether there is such a Python with SciPy; if not, says so on stderr.
bool scipy_is_there(void);

// The nearest ones of all points, their squared distances into the
// scene's array, and how many are within the distance, which are only
// counted. Boxes are not asked. Fails if Python does.
struct range_run run_scipy(struct range_scene *scene);
