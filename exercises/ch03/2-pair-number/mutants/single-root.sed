# The root is taken in single precision, and not corrected.
# expect: A root was rounded
# why: The function is called sqrtf in their other program, and looks as good.
s/sqrt(8.0/sqrtf(8.0f/
/while (triangle(t)/,/t++;/d
