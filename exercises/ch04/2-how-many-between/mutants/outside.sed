# bin_of is asked about bounds that lie in no bin.
# expect: in no bin
# why: bin_of is a function that "finds the bin", and they expect it to cope.
/if (x > bins->border\[bins->count\])/,+1d
