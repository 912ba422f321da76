# Walks up only.
# expect: walk
# why: Sorted lists are usually gone through in one direction.
s/for (uint32_t j = at; j-- > 0;)/for (uint32_t j = 0; j-- > 0;)/;s/for (uint32_t i = at; i-- > 0;)/for (uint32_t i = 0; i-- > 0;)/
