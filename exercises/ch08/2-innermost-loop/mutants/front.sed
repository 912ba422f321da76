# Takes places from the front of the array.
# expect: Another point was met instead
# why: They forget that a cell begins somewhere.
s/start\[strip->cell\[l\]\] + step/step/
