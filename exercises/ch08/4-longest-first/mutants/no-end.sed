# Goes on when no task is left.
# expect: may be shorter than longest allows
# why: They trust "longest" to be the longest.
s/ \&\& places\[b\] > 0//
