# Takes the width for both axes.
# expect: too near
# why: The box of the first tests is a square.
s/gap(box.bottom, box.top, height, y)/gap(box.bottom, box.top, width, y)/
