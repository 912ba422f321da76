# Packs when none is left.
# expect: paid for nothing
# why: The test for packing comes before the test for the end.
s/alive > 0 \&\& //
