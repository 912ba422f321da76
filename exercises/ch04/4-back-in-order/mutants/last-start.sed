# The last start is not computed.
# expect: The last start is where
# why: The loop runs over cells, of which there are m, and there are m + 1 starts.
s/^    free(home)/    start[m] = 0; &/
