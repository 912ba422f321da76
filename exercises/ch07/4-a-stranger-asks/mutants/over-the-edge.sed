# Layers stick out of the grid on the right.
# expect: stick out
s|c >= 0 && c < grid->columns|c >= 0 \&\& c <= grid->columns|
s|return fmax(0, fmax(border\[k\] - x, x - border\[k + 1\]));|return fmax(0, fmax(border[k] - x, k == 99 ? 0 : x - border[k] - 0.001));|
