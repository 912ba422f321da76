# Never joins two spans.
# expect: first of the next: make one
# why: One does not expect two rows to touch.
s/n > 0 && spans\[n - 1\].end == begin/begin > end/
