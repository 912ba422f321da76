# The first row that does not reach far enough ends the search.
# expect: on the other side
# why: The rows seem to come in the order of their bounds, but on one side they are up to a cell further on.
/if (half \* half + dy/,+1s/continue/break/
