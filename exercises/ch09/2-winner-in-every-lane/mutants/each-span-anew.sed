# Begins anew with each span.
# expect: from one span to the next
# why: The registers are declared where they are used, inside the loop over spans.
/for (uint32_t s = 0/s/$/ {/
/keep_nearest(&best, &four/s/$/ }/
/for (uint32_t s = 0/s/$/ for (int l = 0; l < LANES; l++) best.distance2[l] = INFINITY;/
