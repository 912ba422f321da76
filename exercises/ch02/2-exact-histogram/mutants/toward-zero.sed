# The test of the range looks at the bin: -0.5 becomes bin 0.
# expect: toward zero
# why: They reason that a bin below 0 will be noticed, and the conversion makes it 0 before anybody looks.
s/!(value >= low && value <= high)/(value - low) \/ (high - low) * bins <= -1 || value > high || value != value/
s/if (value < edge(low, high, bins, b))/if (b < 0)/
