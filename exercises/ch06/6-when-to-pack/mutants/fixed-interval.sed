# Packs every thirty steps.
# expect: however many lanes are idle
s/idle += lanes - alive/idle++/
s/(uint64_t)price \* lanes/30/
