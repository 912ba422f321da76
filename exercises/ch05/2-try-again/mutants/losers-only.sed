# The winners are sorted out before anybody is counted.
# expect: Only the losers were counted
# why: "Try again" is read as "only then count".
/gather(COUNTS/,/scatter(COUNTS/d
s/^    return losers;/    if (losers > 0) {\
gather(COUNTS, losers, cell, count);\
for (uint32_t l = 0; l < losers; l++) count[l]++;\
scatter(COUNTS, losers, cell, count);\
}\
&/
