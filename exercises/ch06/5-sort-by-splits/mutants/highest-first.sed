# Splits by the highest bit first.
# expect: begin with the lowest bit
s/int k = 0; k < bits; k++/int k = bits; k-- > 0;/
