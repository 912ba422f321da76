# Moves on by one place.
# expect: four places on
s/place += LANES/place++/
