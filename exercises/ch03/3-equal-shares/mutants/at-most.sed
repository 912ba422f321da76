# Every thread takes at most its share, and the last one all the rest.
# expect: left to the last
s/first\[t\] = i;/first[t] = i; done = 0;/
s/done \* threads < all \* (t + 1)/i < n - 1 \&\& (done + n - 1 - i) * threads <= all/
