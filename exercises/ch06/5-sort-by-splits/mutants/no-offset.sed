# The ones begin at place 0, where the zeros are.
# expect: Two values want one place
s/add(first, ones.before)/ones.before/
