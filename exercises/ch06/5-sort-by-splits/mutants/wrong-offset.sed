# The ones begin at the number of the ones.
# expect: begin behind the last zero
s/n - ones.total/ones.total/
