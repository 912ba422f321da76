# Keeps what is near to the lower chain only.
# expect: A corner was let go
# why: The second chain is the first with one sign changed, and the sign is in the wrong place.
s/note_near(place, n, margin, -1, chain)/note_near(place, n, margin, 1, chain)/
