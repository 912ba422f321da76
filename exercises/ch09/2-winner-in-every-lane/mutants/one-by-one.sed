# Moves on by one place.
# expect: four places on
# why: The loop over places is that of the starter.
s/place += LANES/place++/
