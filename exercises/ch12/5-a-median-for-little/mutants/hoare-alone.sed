# Uses no sample.
# expect: Two bounds from a sample
# why: Hoare alone is right, and short.
s/if (n > 600 \&\&/if (n > 4000000000u \&\&/
