# Does not take the way back.
# expect: near enough
# why: The way is set where it is needed.
s/^    search->way\[axis\] = before;$/    (void)before;/
