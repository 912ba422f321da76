# Copies the block for each query anew, lane by lane.
# expect: Find its spans once
# why: The search is written for one query and put into a loop over all.
s/^            fill(sorted, column, row, &buffer);//
s/^                nearest2\[s\] = search/                for (int again = 0; again < 8; again++)\n                    fill(sorted, column, row, \&buffer), nearest2[s] = search/
