# Moves all that comes after a hole.
# expect: straight to its place
# why: To insert is to make room, as in a text.
s/    for (uint32_t i = n; i-- > 0;)/    for (uint32_t i = 0; i < n; i++)/
s/            move(--left, i);/            ;/
s/            clear(i);/        {\n            for (uint32_t k = left++; k > i; k--)\n                move(k - 1, k);\n            clear(i);\n        }/
