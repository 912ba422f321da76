# Point i goes to lane i modulo LANES.
# expect: dealt to the lanes like cards
s/uint32_t i = k; i < n && lanes < LANES; i += block/uint32_t i = k * LANES; i < n \&\& lanes < LANES; i++/
