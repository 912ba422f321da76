# Gives the side's corner first.
# expect: The lower number comes first
# why: A pair is a pair, and halfway around the order turns.
s/{i < j ? i : j, i < j ? j : i, measure/{i, j, measure/
