// Histograms of distances, printed side by side.
#pragma once
#include "common/experiment.h"

enum { BINS = 60 };

struct histogram {
    double low, high;  // what is beyond is counted, but in no bin
    double bins[BINS]; // how many values
    double values;     // in all
};

void histogram_add(struct histogram *histogram, double value);

// A row for each bin: its middle, and the share of the values in it by
// its width, for each of so many histograms.
void print_histograms(const struct histogram *histograms, int count);

// Takes the first argument: true for means, false for histogram.
bool means_wanted(struct experiment *experiment);
