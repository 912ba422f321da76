# Throws away what is outside.
# expect: is inside to the left
# why: With the other order of the directions, left is right.
s/        const double a = points.y\[i\] - points.y\[j\];/        const double a = points.y[j] - points.y[i];/
s/        const double b = points.x\[j\] - points.x\[i\];/        const double b = points.x[i] - points.x[j];/
