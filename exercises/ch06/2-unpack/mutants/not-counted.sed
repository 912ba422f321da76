# The survivors are looked for at the end of the array.
# expect: how many are there
# why: Running backward, they take the source backward as well, from the end of the array.
s/left += keep\[i\]/left++/
