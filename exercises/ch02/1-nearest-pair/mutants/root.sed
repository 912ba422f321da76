# The distance itself instead of its square.
# expect: its root
# why: A distance is a distance, they feel, and the book's habit of squares is read over.
s/return best;/best.distance2 = sqrt(best.distance2); return best;/
