# The difference is taken though b lies before a.
# expect: cannot be negative
s/a < b ? \(.*\) : 0;/\1;/
