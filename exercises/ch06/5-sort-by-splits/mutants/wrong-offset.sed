# The ones begin at the number of the ones.
# expect: begin behind the last zero
# why: Of two totals they take the one that the machine hands them.
s/n - ones.total/ones.total/
