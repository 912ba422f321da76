# Takes places from the front of the array.
# expect: compared with another point
# why: They forget that a cell begins somewhere.
s/start\[strip->cell\[l\]\] + step/step/
