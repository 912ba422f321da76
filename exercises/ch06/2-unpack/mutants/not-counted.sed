# The survivors are looked for at the end of the array.
# expect: how many are there
s/left += keep\[i\]/left++/
