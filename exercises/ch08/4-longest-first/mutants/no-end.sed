# Goes on when nobody is left.
# expect: may be shorter than longest allows
s/ \&\& places\[b\] > 0//
