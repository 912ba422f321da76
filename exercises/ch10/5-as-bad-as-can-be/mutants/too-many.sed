# Does not look whether a step fits.
# expect: outside of the box
# why: The width of a hull is not seen in any one of its steps.
s/room -= sum;//
