# The time of both versions.
# alt: Two lines over the number of points, both rising; the second version
# lies a factor of ten below the first.
plot x
