// Exercise: calipers
#pragma once
#include <stdint.h>

// Two corners, i <= j, and their squared distance.
struct pair {
    uint32_t i, j;
    double d2;
};

// Given. The squared distance of two corners. It counts.
double measure(uint32_t i, uint32_t j);

// Given. How high corner k is above the side from corner i to the next
// one, times the length of that side. It counts.
double height(uint32_t i, uint32_t k);

// The two of n >= 1 corners that are furthest apart; of several pairs
// the one with the lowest i, and then with the lowest j.
struct pair diameter(uint32_t n);
