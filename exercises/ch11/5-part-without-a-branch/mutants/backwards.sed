# Copies what was put aside from its end.
# expect: in their order
# why: A stack is taken down from the top.
s/    memcpy(list + first, room.*/    for (uint32_t k = 0; k < second; k++)\n        list[first + k] = room[second - 1 - k];/
