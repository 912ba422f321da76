# Goes back to the first survivor with each byte.
# expect: has had its place before
# why: The eight flags of a byte are a loop of their own, which begins anew.
s/to\[i\] = set ? \*from : hole;/static const uint32_t *first; first = i == 0 ? from : first; if (i % 8 == 0) from = first; &/
