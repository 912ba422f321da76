# Packs after every step.
# expect: when no task had finished
# why: The figure packs in each step, and so did Su.
s/if (kept == strip->lanes)/if (strip->lanes == 0)/
