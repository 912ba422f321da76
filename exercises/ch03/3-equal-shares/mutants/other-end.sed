# The long rows are taken to be at the end.
# expect: rows become shorter
# why: In the other common form of the loop, with $j < i$, the long rows are at the end.
s/done += n - 1 - i++/done += i++/
