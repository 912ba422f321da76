# Point i goes to lane i modulo LANES.
# expect: dealt to the lanes like cards
# why: Consecutive points to consecutive lanes is what a vector load gives, and what every other loop of the book does.
s/uint32_t i = k; i < n && lanes < LANES; i += block/uint32_t i = k * LANES; i < n \&\& lanes < LANES; i++/
