# The mask is too short.
# expect: Does every pass keep the order
s/0xff/0x7f/
