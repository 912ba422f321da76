# The test comes after the work that it should save.
# expect: Is every distance measured before
s/double dx = .*/double d2 = j == i ? INFINITY : measure(points, i, j); &/
s/double d2 = measure(points, i, j);//
