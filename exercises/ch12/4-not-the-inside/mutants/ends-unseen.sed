# Takes the ends of a row unseen.
# expect: was taken unseen
# why: The rows are at the border, but are not the columns, too?
s/count += look(start, first, first);/count += start[first + 1] - start[first];/
