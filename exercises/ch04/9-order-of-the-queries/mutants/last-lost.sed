# The last query is not answered.
# expect: never set
# why: The loop ends one too early.
s/for (uint32_t s = 0; s < n; s++)/for (uint32_t s = 0; s + 1 < n; s++)/
