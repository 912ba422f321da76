# Looks for the old rank among what was kept.
# expect: below what was kept
# why: The kept ones look like a problem of their own.
s/return find(room, kept, rank - below);/return find(room, kept, rank < kept ? rank : kept - 1);/
