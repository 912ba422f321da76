# Takes a 0 at an edge for outside.
# expect: through an edge or a corner
# why: Equal signs are what one has in mind, and 0 is another sign.
s/right |= way < 0;/right |= way <= 0;/
s/left |= way > 0;/left |= way >= 0;/
