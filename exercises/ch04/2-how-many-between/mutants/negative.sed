# The difference is taken though b lies before a.
# expect: cannot be negative
# why: They assume that the caller puts the smaller bound first.
s/a < b ? \(.*\) : 0;/\1;/
