# Packs as soon as the idle lanes have cost half a pack.
# expect: Compare two sums
# why: Twice the least is a bound; they tune the constant until their own example is cheapest.
s/idle >= /2 * &/
