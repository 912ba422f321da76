# Goes on while the next corner is not lower.
# expect: just as high is not higher
# why: A search for a maximum works with either comparison, elsewhere.
s/height(i, (k + 1) % n) > height/height(i, (k + 1) % n) >= height/
