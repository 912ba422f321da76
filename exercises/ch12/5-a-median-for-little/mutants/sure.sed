# Trusts the bounds though they are far too close.
# expect: below what was kept
# why: It is right nearly always.
s/gap = 1.5 \* sqrt(m)/gap = 0.02 * sqrt(m)/;s/if (rank >= below && rank - below < kept)/if (kept > 0)/;s/return find(room, kept, rank - below);/return find(room, kept, rank < below ? 0 : rank - below < kept ? rank - below : kept - 1);/
