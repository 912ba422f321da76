# Both stretches must have a beginning.
# expect: or, not and
s/left.begins || /left.begins \&\& /
