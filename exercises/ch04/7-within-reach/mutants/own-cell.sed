# The pairs inside a cell are forgotten.
# expect: these two share one
/uint32_t j = lists->next\[i\]/,/try/s/try(/if (0) try(/
