# Writes the next survivor where the hole belongs.
# expect: the hole belongs there
# why: In a pack what stands between is garbage, and is not asked for.
s/set ? \*from : hole/*from/
