# It begins with the highest byte, as one sorts words by hand.
# expect: begin with the lowest
# why: It is how one sorts words, or letters, by hand.
s/for (int b = 0; b < BYTES; b++)$/for (int b = BYTES - 1; b >= 0; b--)/
