# Takes the points on the border of the box only.
# expect: this one is thrown away
# why: They confuse the box of the points with the octagon between them.
s/^    for (int s = 0; s < sides; s++)/    for (int s = 0; s < 1; s++)/
