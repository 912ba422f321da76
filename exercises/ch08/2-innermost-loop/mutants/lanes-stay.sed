# Packs, and goes on with as many lanes.
# expect: A lane has gone on after
s/^    strip->lanes = kept;//
