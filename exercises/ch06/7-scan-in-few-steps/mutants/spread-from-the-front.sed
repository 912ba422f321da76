# Spreads the results from the front, over those still needed.
# expect: still needed
# why: The direction of a loop is chosen after the first failure.
s/i = half; i-- > 0;/i = 0; i < half; i++/
