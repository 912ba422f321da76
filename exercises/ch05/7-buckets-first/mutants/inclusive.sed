# The scan leaves ends in place of beginnings.
# expect: runs past the end
# why: The sum is stored after the addition.
s/count\[b\] = sum;/here += 0;/; s/sum += here;/sum += here; count[b] = sum;/
