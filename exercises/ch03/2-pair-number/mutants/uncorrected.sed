# The root is not corrected: 64 bits do not fit into a double.
# expect: A root was rounded
# why: The root gave the right row in all their trials; a rounding shows from about 2 to the 26th points on.
/while (triangle(t)/,/t++;/d
