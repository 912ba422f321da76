# Takes the value first and counts down afterward.
# expect: the last one stands at place k - 1
# why: "values[left--]" and "values[--left]" are told apart by trying.
s/--left/left--/
