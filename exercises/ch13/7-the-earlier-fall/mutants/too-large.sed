# Takes all integers for exact.
# expect: only if nothing was rounded
# why: Integers are exact, and that products are larger is forgotten.
s/fabs(x) <= 0x1p25 && //
