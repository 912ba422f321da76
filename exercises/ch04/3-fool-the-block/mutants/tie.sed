# Decoys are as near as the neighbors.
# expect: These tie
# why: A square of four points looks as deceptive as a rectangle.
s/{0\.9, 2\.1, 0\.9, 2\.1}/{0.75, 2.25, 0.75, 2.25}/
