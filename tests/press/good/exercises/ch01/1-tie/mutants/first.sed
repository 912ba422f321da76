# It keeps the first.
# expect: names the "first"
# why: `<` is what they know.
s/<=/</
