# Goes on as long as the distance grows.
# expect: as long as the distance grows
# why: It needs one function less, and on a round hull it is right.
s/while (height(i, (k + 1) % n) > height(i, k))/while (measure(i, (k + 1) % n) > measure(i, k))/
