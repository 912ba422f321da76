//> Declare the response
// Before each step impulses change velocities so that where bodies have
// touched nothing approaches (Baraff 1989; sequential impulses: Mirtich
// and Canny 1995, Catto 2005).
#pragma once
#include "ch13-contact/contact_cache.h"

// Changes velocities by impulses at all contacts, one after the other,
// in as many rounds as the cache says. No position is changed.
void solve_contacts(const struct contact_cache *cache,
                    struct scene *scene);
//<
