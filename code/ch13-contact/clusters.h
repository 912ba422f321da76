//> Declare the broad phase by clusters
// Two levels: triangles that follow each other in the mesh, up to
// CLUSTER of one body, are a cluster with a box of its own. Clusters
// whose boxes meet are found by another broad phase; of two such, only
// triangles that reach into the other's box are compared (after Cohen
// and others 1995, whose first level are whole bodies).
#pragma once
#include "ch13-contact/broad_phase.h"

enum { CLUSTER = 32 };

// The row's inner is the name of the broad phase for the clusters.
void *begin_clusters(const struct broad_phase *phase);
void find_by_clusters(void *kept, const struct broad_search *search);
void end_clusters(void *kept);
//<
