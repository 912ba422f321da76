# The next four begin too near.
# expect: wherever they lie
s/= 3 \* (four %/= 2 * (four %/
