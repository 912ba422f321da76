# The number of cells is not limited.
# expect: ended the program, with status 2
# why: The number of cells follows from the radius, and one of $10^{-9}$ is never tried.
s/fit < most ? (uint32_t)fit : most/fit < 4e9 ? (uint32_t)fit : 4000000000; (void)most/
