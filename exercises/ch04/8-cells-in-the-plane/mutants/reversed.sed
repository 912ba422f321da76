# Cells are filled from their ends, but the points come first to last.
# expect: not the order in it
# why: One of the two directions was turned, and not the other.
s/for (uint32_t i = points.n; i-- > 0;)/for (uint32_t i = 0; i < points.n; i++)/
