# Packs when nobody is left.
# expect: paid for nothing
s/alive > 0 \&\& //
