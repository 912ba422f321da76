# Ends the merge with the list that was kept.
# expect: not taken to its end
# why: The loop runs while both have something.
s/for (uint32_t place = n; out > 0;)/for (uint32_t place = n; out > 0 \&\& kept > 0;)/
