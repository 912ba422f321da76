# Works off one task after the other.
# expect: Order them once
# why: It is the plain loop, right and idle.
s/^        make_round(places\[b\], order);/        for (uint32_t l = 0; l < places[b]; l++)\n            make_round(1, order + l);/
