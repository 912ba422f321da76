# Looks at one lane in the end.
# expect: do all take part in the end
# why: A vector has one result, they feel, and it is in the first lane.
s/for (int l = 0; l < LANES; l++) {$/&/
/nearest_lane(const/,/^}/s/l < LANES/l < 1/
