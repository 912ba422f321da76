//> Declare the response
// Before each step impulses change velocities so that where bodies have
// touched nothing approaches (Baraff 1989; sequential impulses: Mirtich
// and Canny 1995, Catto 2005).
#pragma once
#include "ch13-contact/touches.h"

// Changes velocities by impulses at all touches, one after the other,
// in so many rounds.
void push_apart(const struct touches *touches, struct scene *scene);
//<
