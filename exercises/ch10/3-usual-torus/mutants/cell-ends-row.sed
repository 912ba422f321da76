# The first cell that does not reach far enough ends the row.
# expect: about the next cell
# why: The cells seem to come in the order of their bounds, but on one side they are up to a cell further on.
/if (dx \* dx + dy/,+1s/continue/break/
