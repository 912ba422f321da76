# Packs, and goes on with as many lanes.
# expect: A lane has gone on after
# why: The number of lanes is returned by pack, and they drop what it returns.
s/^    strip->lanes = kept;//
