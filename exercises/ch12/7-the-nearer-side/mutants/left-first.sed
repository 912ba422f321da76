# Always goes left first.
# expect: nearer side first
# why: Left comes first in the text.
s/const int right = to_right < to_left;/const int right = 0;/
