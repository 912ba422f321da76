// Pictures of the steps, by gnuplot.
#pragma once
#include "ch13-contact/step.h"

// Makes the folder, if it is not there, and in it a script that draws
// every picture; fails if that cannot be done.
void pictures_begin(const char *folder, const struct scene *scene,
                    uint32_t steps);

// Writes the data of a picture, if this step is to have one: at most
// MAX_PICTURES do, the last one among them.
enum { MAX_PICTURES = 24 };
void pictures_add(const char *folder, const struct simulation *s,
                  uint32_t step, uint32_t steps);
