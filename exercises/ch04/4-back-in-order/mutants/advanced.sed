# The starts themselves are advanced.
# expect: has to set them back
s/^    free(home)/    memcpy(start, start + 1, m * sizeof *start); &/
