//> Declare the portable primitives
// primitives.h says what each does. The vector versions call them for
// what is less than a vector, and where they have nothing better.
#pragma once
#include "ch06-pack-scan/primitives.h"

void portable_add(double *to, const double *a, const double *b,
                  uint32_t n);
void portable_gather(double *to, const double *from,
                     const uint32_t *index, uint32_t n);
void portable_gather32(uint32_t *to, const uint32_t *from,
                       const uint32_t *index, uint32_t n);
void portable_scatter(double *to, const double *from,
                      const uint32_t *index, uint32_t n);
void portable_scatter32(uint32_t *to, const uint32_t *from,
                        const uint32_t *index, uint32_t n);
uint32_t portable_scan(uint32_t *to, const uint32_t *from, uint32_t n,
                       uint32_t sum);
uint32_t portable_pack(uint32_t *to, const uint32_t *from,
                       const uint8_t *keep, uint32_t n);

extern const struct primitives portable_primitives;
//<
