# Layers stick out of the grid on the right.
# expect: stick out
# why: Three of the four edges are tested, because unsigned numbers catch the rest by accident.
s|c >= 0 && c < grid->columns|c >= 0 \&\& c <= grid->columns|
s|return fmax(0, fmax(border\[k\] - x, x - border\[k + 1\]));|return fmax(0, fmax(border[k] - x, k == 99 ? 0 : x - border[k] - 0.001));|
