# Squares what is negative.
# expect: nothing is certain
# why: Two lines earlier it was a distance, and distances are positive.
s/certain > 0 && //
