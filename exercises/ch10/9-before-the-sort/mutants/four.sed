# Takes four directions.
# expect: Four directions leave much
# why: The box has four sides, and its extreme points are found anyway.
s/DIRECTIONS = 8 };/DIRECTIONS = 4 };/
s/= {1, 1, 0, -1, -1, -1, 0, 1}/= {1, 0, -1, 0}/
s/= {0, 1, 1, 1, 0, -1, -1, -1}/= {0, 1, 0, -1}/
