# Asks for all signs first.
# expect: Two signs tell
# why: Signs are gathered in arrays before the cases are told apart.
s/^    if (begin \* end > 0)/    const bool through = line_goes_through();\n    if (begin * end > 0)/
s/return line_goes_through();/return through;/
