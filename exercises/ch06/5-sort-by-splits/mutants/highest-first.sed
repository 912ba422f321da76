# Splits by the highest bit first.
# expect: begin with the lowest bit
# why: It is the important one, after all.
s/int k = 0; k < bits; k++/int k = bits; k-- > 0;/
