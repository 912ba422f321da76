# Answers with the distance in single precision.
# expect: distance in single precision
s/found = (struct found){j, d2}/found = (struct found){j, scratch[s]}/
