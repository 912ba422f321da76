# Decoys are as near as the neighbors.
# expect: These tie
s/{0\.9, 2\.1, 0\.9, 2\.1}/{0.75, 2.25, 0.75, 2.25}/
