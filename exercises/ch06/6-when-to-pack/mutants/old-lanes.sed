# Forgets that a pack leaves fewer lanes.
# expect: After a pack there are fewer lanes
# why: The number of lanes is a parameter, and one does not expect it to change.
s/^ *lanes = alive;//
