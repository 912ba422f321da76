// Marks that rest on how something grows, and on time.
#include "grader.h"
#include <math.h>
#include <omp.h>

double kit_growth(int count, const double *n, const double *cost)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    for (int k = 0; k < count; k++) {
        double u = log(n[k]), v = log(cost[k]);
        x += u;
        y += v;
        xx += u * u;
        xy += u * v;
    }
    return (count * xy - x * y) / (count * xx - x * x);
}

void kit_bands(double value, const struct kit_band *bands,
               struct kit_fault fault)
{
    const struct kit_band *band = bands;
    while (band->most > 0 && !(value <= band->most))
        band++;
    if (band == bands)
        return;
    fault.points = band->most > 0 ? band->points : 0;
    kit_wrong(fault);
}

// The three shortest times. If they do not agree, the shortest is an
// accident.
struct best {
    double first, second, third;
};

static void take(struct best *best, double seconds)
{
    if (seconds < best->first) {
        *best = (struct best){seconds, best->first, best->second};
    } else if (seconds < best->second) {
        best->third = best->second;
        best->second = seconds;
    } else if (seconds < best->third) {
        best->third = seconds;
    }
}

static bool agree(struct best best)
{
    const double spread = 1.4;
    return best.third <= spread * best.first;
}

// Who takes that many times as long has lost at once: no band is near.
static bool is_lost(struct best student, struct best reference)
{
    const double times = 50;
    return student.first > times * reference.first;
}

double kit_race(struct kit_race race)
{
    enum { TRIALS_MIN = 5, TRIALS_MAX = 25 };
    const int least = race.trials > 0 ? race.trials : TRIALS_MIN;
    if (kit_is_sanitized()) {
        race.student();
        return 0;
    }
    int cores = omp_get_num_procs();
    if (race.cores > cores)
        kit_not_graded(kit_text("this machine has %d of the %d "
                                "processors that it takes",
                                cores, race.cores));
    struct best student = {INFINITY, INFINITY, INFINITY};
    struct best reference = student;
    for (int trial = 0; trial < TRIALS_MAX; trial++) {
        race.reference();
        take(&reference, kit_seconds(race.cores > 1));
        race.student();
        take(&student, kit_seconds(race.cores > 1));
        if ((trial + 1 >= least && agree(student) &&
             agree(reference)) ||
            (trial > 0 && is_lost(student, reference)))
            return grader.ratio = student.first / reference.first;
    }
    kit_not_graded("this machine is too noisy: no three runs took the "
                   "same time");
}
