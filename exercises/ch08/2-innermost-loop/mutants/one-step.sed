# Takes only one step.
# expect: took one step only
# why: It is the starter with the empty cells repaired.
s/strip->lanes > 0; step++/step < 1 \&\& strip->lanes > 0; step++/
