# The pairs inside a cell are forgotten.
# expect: these two share one
# why: They list the neighbors, and a cell is not its own neighbor.
/uint32_t j = lists->next\[i\]/,/try/s/try(/if (0) try(/
