# A gap less than 0 is squared.
# expect: nearer
# why: Squares hide the sign.
s/return fmax(0, fmin(direct, around))/return fmin(direct, around)/
