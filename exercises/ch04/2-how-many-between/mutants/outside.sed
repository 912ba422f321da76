# bin_of is asked about bounds that lie in no bin.
# expect: in no bin
/if (x > bins->border\[bins->count\])/,+1d
