# Leaves the other points as they are.
# expect: Was it ever set
# why: All corners are there, and nobody looks at the rest.
s/for (; i < points.n; i++)/for (; 0; i++)/
