# Measures from the border to the wrong point.
# expect: and was not measured
# why: The border is 0 in their own first test.
s/double dx = border - p->x/double dx = border - 2 * p->x/
