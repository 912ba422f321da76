# The root is not corrected: 64 bits do not fit into a double.
# expect: A root was rounded
/while (triangle(t)/,/t++;/d
