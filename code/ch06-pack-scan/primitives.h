//> Declare the primitives
// What a vector machine does with whole arrays (Iverson 1962, Blelloch
// 1990): elementwise arithmetic, routes, which are gather and scatter,
// scan and pack. One table of functions for each instruction set; all
// give the same results, to the last bit. n may be 0. Arrays overlap
// only where it says so.
#pragma once
#include "common/isa.h"
#include <stdint.h>

struct primitives {
    enum isa isa;

    //> Declare elementwise arithmetic and routes
    // to[i] = a[i] + b[i]. The array to may be the array a or b.
    void (*add)(double *to, const double *a, const double *b,
                uint32_t n);

    // to[i] = from[index[i]]. The arrays to and from may be the same if
    // no index[i] < i.
    void (*gather)(double *to, const double *from,
                   const uint32_t *index, uint32_t n);
    void (*gather32)(uint32_t *to, const uint32_t *from,
                     const uint32_t *index, uint32_t n);

    // to[index[i]] = from[i]; of equal indices the last i wins.
    void (*scatter)(double *to, const double *from,
                    const uint32_t *index, uint32_t n);
    void (*scatter32)(uint32_t *to, const uint32_t *from,
                      const uint32_t *index, uint32_t n);
    //<

    //> Declare scan and pack
    // to[i] = sum + from[0] + ... + from[i-1], modulo 2^32. Returns
    // sum + from[0] + ... + from[n-1]. The arrays may be the same.
    uint32_t (*scan)(uint32_t *to, const uint32_t *from, uint32_t n,
                     uint32_t sum);

    // Moves the from[i] whose keep[i] is 1, not 0, to the front of
    // to[0 .. n-1], in order, and returns how many. Up to SPILL numbers
    // behind these may be overwritten, but none behind to[n-1]. to and
    // from may be the same.
    uint32_t (*pack)(uint32_t *to, const uint32_t *from,
                     const uint8_t *keep, uint32_t n);
    //<
};
enum { SPILL = 16 };

// The table for an instruction set, which must be present.
const struct primitives *primitives(enum isa isa);

extern const struct primitives portable_primitives, avx2_primitives,
    avx512_primitives;

//> Declare the portable primitives
// The vector versions call them for what is less than a vector, and
// where they have nothing better.
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
//<
//<
