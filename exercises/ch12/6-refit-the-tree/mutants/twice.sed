# Looks at the points of a leaf twice for each bound.
# expect: hand up the box
# why: One loop for the least, one for the greatest.
s/const double number = number_at(s, axis);/double number = number_at(s, axis);\n            for (int again = 0; again < 4; again++)\n                number = number_at(s, axis);/
