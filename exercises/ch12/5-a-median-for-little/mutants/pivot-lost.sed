# Forgets that the pivot has a rank.
# expect: next to it
# why: The pivot is neither below nor above.
s/rank -= below + 1;/rank -= below;/
