# Each lane sees every eighth candidate, and only its own query.
# expect: Has each lane seen all candidates
# why: They mix eight candidates for a query with eight queries for a candidate.
s/double cx = to.x\[j\], cy = to.y\[j\];//; s/distance2(cx - qx\[l\], cy - qy\[l\])/j % LANES == (uint32_t)l || to.n < LANES ? distance2(to.x[j] - qx[l], to.y[j] - qy[l]) : best[l]/
