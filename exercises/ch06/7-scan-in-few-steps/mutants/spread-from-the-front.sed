# Spreads the results from the front, over those still needed.
# expect: still needed
s/i = half; i-- > 0;/i = 0; i < half; i++/
