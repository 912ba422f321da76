# Says that nothing meets in the plane.
# expect: there is none
# why: It happens with probability 0.
s/return meet_in_plane();/return meet_in_plane() \&\& 0;/
