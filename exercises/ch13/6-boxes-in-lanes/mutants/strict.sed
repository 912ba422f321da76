# Lets boxes that touch be apart.
# expect: To touch is to meet
# why: Less and greater come to mind first.
s/(low_y\[i\] <= b.high\[1\])/(low_y[i] < b.high[1])/
