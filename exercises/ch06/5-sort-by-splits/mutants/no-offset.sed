# The ones begin at place 0, where the zeros are.
# expect: Two values want one place
# why: The ones are scanned and placed, and the zeros are placed over them.
s/add(first, ones.before)/ones.before/
