# Takes places for sources.
# expect: scatter, not gather
s/scatter(/gather(/
