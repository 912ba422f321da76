# The mask is too short.
# expect: Does every pass keep the order
# why: 127 is a number that one remembers, and text never noticed.
s/0xff/0x7f/
