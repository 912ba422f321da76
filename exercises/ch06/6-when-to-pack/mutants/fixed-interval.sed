# Packs every thirty steps.
# expect: however many lanes are idle
# why: The chapter has a formula for the best interval, and they solve it for one set of lifetimes.
s/idle += lanes - alive/idle++/
s/(uint64_t)price \* lanes/30/
