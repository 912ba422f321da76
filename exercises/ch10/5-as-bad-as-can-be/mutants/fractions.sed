# Puts points between the whole numbers.
# expect: Round them
# why: The hull is moved into the middle of the box, by half of what is left.
s/^    double x = 0, y = 0;/    double x = 0.5, y = 0;/
