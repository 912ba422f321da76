# Stops where somebody beyond the border may just tie.
# expect: though no point in it can be nearer
# why: For the distance alone it is right.
s/best.d2 < certain \* certain/best.d2 <= certain * certain/
