//> Answer for one point
// The nearest of some numbers to the first of them, and how often we
// looked. A small program to try the press on.
#include <math.h>
#include <stdio.h>

//> Find the number nearest to the first
static int nearest(const double *x, int n)
{
    int best = -1;
    double distance = INFINITY; /* nothing is nearer
                                   than nothing */
    for (int j = 1; j < n; j++) {
        //> Keep the number if it is nearer
        double d = fabs(x[j] - x[0]);
        if (d < distance) {
            distance = d;
            best = j;
        }
        //<
    }
    return best;
}
//<

int main(void)
{
    const double x[] = {3.0, 1.0, 4.0, 1.5, 9.0};
    printf("%d\n", nearest(x, 5)); // "2", in fact
    return 0;
}
//<
