# Eight times the number is computed in 64 bits, which are too few.
# expect: does not fit into 64 bits
# why: They heard of 53 bits and made it an integer; the guess is far off then, and the correction walks.
s/8\.0 \* behind + 1/(double)(8 * behind + 1)/
