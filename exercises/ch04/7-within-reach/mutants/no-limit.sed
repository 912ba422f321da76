# The number of cells is not limited.
# expect: ended the program, with status 2
s/fit < most ? (uint32_t)fit : most/fit < 4e9 ? (uint32_t)fit : 4000000000; (void)most/
