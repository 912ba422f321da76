// Counts values in bins of equal width: a few steps for each.
#include "ch02-all-pairs/experiments/histogram.h"

void histogram_add(struct histogram *histogram, double value)
{
    double place = (value - histogram->low) /
                   (histogram->high - histogram->low) * BINS;
    if (place >= 0 && place < BINS)
        histogram->bins[(int)place]++;
    histogram->values++;
}

void print_histograms(const struct histogram *histograms, int count)
{
    for (int bin = 0; bin < BINS; bin++) {
        for (int k = 0; k < count; k++) {
            const struct histogram *h = &histograms[k];
            double width = (h->high - h->low) / BINS;
            row_cells("%s%.6g\t%.6g", k ? "\t" : "",
                      h->low + (bin + 0.5) * width,
                      h->bins[bin] / h->values / width);
        }
        row_end();
    }
}

bool means_wanted(struct experiment *experiment)
{
    const char *what = experiment->next < experiment->argc
                           ? experiment->argv[experiment->next++]
                           : "";
    const bool means = strcmp(what, "means") == 0;
    if (!means && strcmp(what, "histogram") != 0)
        fail("say what to print: means or histogram");
    return means;
}
