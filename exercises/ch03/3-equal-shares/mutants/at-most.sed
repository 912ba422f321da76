# Every thread takes at most its share, and the last one all the rest.
# expect: left to the last
# why: "Not more than my share" sounds fair, and each thread leaves the rest of a row to the last.
s/first\[t\] = i;/first[t] = i; done = 0;/
s/done \* threads < all \* (t + 1)/i < n - 1 \&\& (done + n - 1 - i) * threads <= all/
