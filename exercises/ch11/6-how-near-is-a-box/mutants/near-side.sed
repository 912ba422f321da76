# Over the seam it takes the nearer end of the interval.
# expect: nearer
# why: What is near is near, one thinks.
s/period - fmax(x - low, high - x)/period - fmin(fabs(x - low), fabs(high - x))/
