// Numbers written and read back, by both ways: the one that was built,
// and that of the C library.
#include "common/numbers.h"
#define number_from_text plain_from_text
#define number_to_text plain_to_text
#include "common/numbers.c"
#undef number_from_text
#undef number_to_text
#include "common/random.h"
#include "harness.h"
#include "reader.h"
#include <float.h>
#include <stdint.h>

static double double_of(uint64_t bits)
{
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

// Even in [0, 1), of any size, subnormal, or with few digits.
static double draw(struct random *random, uint32_t k)
{
    const uint64_t bits = random_bits(random);
    const double even = (bits >> 11) * 0x1p-53;
    double number = double_of(bits);
    if (k % 4 == 1)
        return even;
    if (k % 4 == 2)
        return double_of(bits & 0x800fffffffffffff);
    if (k % 4 == 3)
        return (double)(bits >> 44) / 1000;
    return isfinite(number) ? number : even;
}

// Whether these functions give the same double back, sign and all.
static bool survives(char *(*write)(char *, double),
                     const char *(*read)(const char *, double *),
                     double number)
{
    char text[LONGEST_NUMBER + 1];
    double again = 0;
    char *end = write(text, number);
    *end = 0;
    return end < text + LONGEST_NUMBER && read(text, &again) == end &&
           memcmp(&again, &number, sizeof again) == 0;
}

void numbers_survive(void)
{
    struct random random = {1};
    const uint32_t n = at_most("MOST_CASES", 10000000);
    uint32_t lost = 0;
    double first = 0;
    for (uint32_t k = 0; k < n; k++) {
        double number = draw(&random, k);
        if (!survives(number_to_text, number_from_text, number) &&
            lost++ == 0)
            first = number;
    }
    CHECK_INT(0, lost, "numbers lost of %u, the first %a", (unsigned)n,
              first);
}

void extreme_numbers_survive(void)
{
    static const double numbers[] = {
        0,           -0.0,         1,
        -1,          DBL_MIN,      DBL_MAX,
        -DBL_MAX,    DBL_TRUE_MIN, 0x1p-44,
        0x1p1023,    1e-5,         9.9999e-5,
        1e-4,        1e15,         1e16,
        1e22,        1e23,         999999999999999,
        0.1,         1. / 3,       0x1p53,
        DBL_EPSILON, INFINITY,     -INFINITY};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
        CHECK(survives(number_to_text, number_from_text, numbers[k]),
              "%a", numbers[k]);
        CHECK(survives(plain_to_text, plain_from_text, numbers[k]),
              "%a, plainly", numbers[k]);
    }
}

static void check_text_of(const char *expected, double number)
{
    char text[LONGEST_NUMBER + 1];
    *number_to_text(text, number) = 0;
    CHECK_TEXT(expected, text, "%a", number);
    *plain_to_text(text, number) = 0;
    CHECK_TEXT(expected, text, "%a, plainly", number);
}

void numbers_are_short(void)
{
    check_text_of("0.1", 0.1);
    check_text_of("-245552.778", -245552.778);
    check_text_of("100000", 1e5);
    check_text_of("123456789012345", 123456789012345);
    check_text_of("1e+15", 1e15);
    check_text_of("1.2345678901234568e+17", 123456789012345680.0);
    check_text_of("0.0001", 1e-4);
    check_text_of("1e-05", 1e-5);
    check_text_of("5e-324", DBL_TRUE_MIN);
    check_text_of("1.7976931348623157e+308", DBL_MAX);
    check_text_of("0", 0);
    check_text_of("-0", -0.0);
    check_text_of("inf", INFINITY);
}

// Texts that may be a number, or begin with one.
void both_ways_read_alike(void)
{
    static const char letters[] = "001234567899.+-eEinfatyxX() ";
    struct random random = {2};
    const uint32_t n = at_most("MOST_CASES", 300000);
    for (uint32_t k = 0; k < n; k++) {
        char text[16] = "";
        const int length = 1 + random_bits(&random) % (k % 2 ? 5 : 12);
        const int kinds = k % 3 ? 19 : sizeof letters - 1;
        for (int c = 0; c < length; c++)
            text[c] = letters[random_bits(&random) % kinds];
        double number = 0, plain = 0;
        const char *end = number_from_text(text, &number);
        if (!CHECK_INT(plain_from_text(text, &plain) - text, end - text,
                       "where \"%s\" ends", text) ||
            !CHECK(end == text || isnan(number) == isnan(plain),
                   "\"%s\"", text) ||
            !CHECK(end == text || isnan(plain) ||
                       memcmp(&number, &plain, sizeof number) == 0,
                   "\"%s\" is %a and %a", text, number, plain))
            break;
    }
}
