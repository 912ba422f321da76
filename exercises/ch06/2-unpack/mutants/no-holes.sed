# Only survivors are written.
# expect: clear the place
# why: They see the survivors in their right places, and forget what stood between.
s/clear(i)/(void)i/
