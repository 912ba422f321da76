# The test comes after the work that it should save.
# expect: Is every distance measured before
# why: They compute the distance where they always did, and then ask whether it was worth it.
s/double dx = .*/double d2 = j == i ? INFINITY : measure(i, j); &/
s/double d2 = measure(i, j);//
