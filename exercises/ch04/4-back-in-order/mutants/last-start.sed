# The last start is not computed.
# expect: The last start is where
s/^    free(home)/    start[m] = 0; &/
