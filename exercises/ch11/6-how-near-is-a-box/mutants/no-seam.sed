# There is no way around.
# expect: both ways around
# why: The plane is what we are used to.
s/fmin(direct, around)/fmax(direct, direct - 0 * around)/
