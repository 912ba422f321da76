# The points are placed forward, from the starts, which end as ends.
# expect: This is where the cell ends
# why: The loop that places is right, and the starts look right before it.
s/sum += start\[k\];/uint32_t here = start[k];/; s/start\[k\] = sum;/start[k] = sum; sum += here;/
s/for (uint32_t i = points.n; i-- > 0;)/for (uint32_t i = 0; i < points.n; i++)/; s/--start\[k\]/start[k]++/
