# Answers with the distance in single precision.
# expect: distance in single precision
# why: The distance of the winner is in the array already.
s/found = (struct found){j, d2}/found = (struct found){j, scratch[s]}/
