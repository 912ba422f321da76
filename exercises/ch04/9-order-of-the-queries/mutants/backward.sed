# The rows come last to first.
# expect: Queries of one row want the same points
# why: Counted down, the order looks as good as upward; it is, for the cache, and it is not what was agreed.
s/for (uint32_t s = 0; s < n; s++)/for (uint32_t s = n; s-- > 0;)/
