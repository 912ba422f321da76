# Exchanges in the last place, too.
# expect: of no interest any more
# why: All places are treated alike, and one operation for each key is in vain.
s/i + 1 < k; i++)/i < k; i++)/
/kept\[k - 1\] = least/d
s/return k >= 4 \&\& /return k > 99999 \&\& /
