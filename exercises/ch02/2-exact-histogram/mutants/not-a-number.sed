# Both comparisons with NaN are false, so it passes for a value inside.
# expect: NaN
# why: "Not below and not above" sounds like "inside", and is, for numbers.
s/!(value >= low && value <= high)/value < low || value > high/
s/int b = (int)(\(.*\));/int b = value == value ? (int)(\1) : 0;/
