# Packs as soon as the idle lanes have cost half a pack.
# expect: Compare two sums
s/idle >= /2 * &/
