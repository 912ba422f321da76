# Takes places from the front of the array.
# expect: Somebody else was met instead
s/start\[strip->cell\[l\]\] + step/step/
