# The pair lies in columns that touch.
# expect: wherever they lie
s/2\.1, 0\.9, 2\.1/1.7, 0.9, 1.7/
