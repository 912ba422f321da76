# Takes the first of those that tie.
# expect: These tie
# why: In double precision the first of equal ones stays, and the candidates are in the order of cells.
s/(d2 == found.nearest2 \&\&/(0 \&\&/
