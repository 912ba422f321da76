# Drops all but the first of each x.
# expect: point
# why: Duplicates are dropped as in the hull, by comparing too little.
s/    qsort(place, n, sizeof \*place, from_left);/&\n    uint32_t m = 1;\n    for (uint32_t k = 1; k < n; k++)\n        if (place[k].x != place[m - 1].x)\n            place[m++] = place[k];/
s/note_near(place, n,/note_near(place, m,/
/if (place\[k\].near)/s/if (/if (k < m \&\& /
