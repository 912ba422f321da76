# Forgets that a pack leaves fewer lanes.
# expect: After a pack there are fewer lanes
s/^ *lanes = alive;//
