# The long rows are taken to be at the end.
# expect: rows become shorter
s/done += n - 1 - i++/done += i++/
