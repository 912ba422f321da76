# Takes places for sources.
# expect: scatter, not gather
# why: The two are each other's inverse, and on small symmetric examples they agree.
s/scatter(/gather(/
