# Both stretches must have a beginning.
# expect: or, not and
# why: Two conditions are joined, and "and" sounds like joining.
s/left.begins || /left.begins \&\& /
