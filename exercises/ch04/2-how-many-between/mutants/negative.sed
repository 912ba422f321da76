# The difference is taken though b lies before a.
# expect: cannot be negative
# why: They assume that whoever asks puts the smaller bound first.
s/a < b ? \(.*\) : 0;/\1;/
