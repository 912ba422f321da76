# Takes only one step.
# expect: took one step only
s/strip->lanes > 0; step++/step < 1 \&\& strip->lanes > 0; step++/
