# Packs after every step.
# expect: when nobody had finished
s/if (kept == strip->lanes)/if (strip->lanes == 0)/
