# It begins with the highest byte, as one sorts words by hand.
# expect: begin with the lowest
s/for (int b = 0; b < BYTES; b++)$/for (int b = BYTES - 1; b >= 0; b--)/
