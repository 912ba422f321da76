// Count the wrong guesses of simple branch predictors.
// Random marks, of which a share is 1, are guessed one after the other:
// as the commoner kind; as the last mark; by a counter of two bits; and
// by such a counter for each pattern of the last 12 or 20 marks. Wrong
// guesses for an element in the last of several passes over the same
// marks; in the last column, over the first thousand of them.
#include "common/experiment.h"

enum { MARKS = 1 << 17, FEW = 1000, LONGEST = 20, PASSES = 10 };

// A counter is 0 to top, and every mark moves it by one; the upper half
// guesses 1.
static uint8_t counters[1 << LONGEST];

static void move(uint8_t *counter, uint8_t mark, int top)
{
    if (mark && *counter < top)
        ++*counter;
    if (!mark && *counter > 0)
        --*counter;
}

// Wrong guesses for an element, where the last history marks choose the
// counter. With top 1 a counter repeats the last mark.
static double wrong(const uint8_t *marks, uint32_t n, int history,
                    int top)
{
    const uint32_t patterns = 1u << history;
    uint32_t last = 0, wrong = 0;
    for (uint32_t k = 0; k < patterns; k++)
        counters[k] = 0;
    for (uint32_t i = 0; i < PASSES * n; i++) {
        uint8_t *counter = &counters[last], mark = marks[i % n];
        if (i >= (PASSES - 1) * n)
            wrong += (*counter > top / 2) != mark;
        move(counter, mark, top);
        last = (last << 1 | mark) & (patterns - 1);
    }
    return (double)wrong / n;
}

static void print_row(int percent)
{
    static uint8_t marks[MARKS];
    struct random random = {percent + 1};
    for (uint32_t i = 0; i < MARKS; i++)
        marks[i] = random_uniform(&random) * 100 < percent;
    int rarer = percent < 50 ? percent : 100 - percent;
    row("kept_%d\t%d\t%.4f\t%.4f\t%.4f\t%.4f\t%.4f\t%.4f", percent,
        percent, rarer / 100.0, wrong(marks, MARKS, 0, 1),
        wrong(marks, MARKS, 0, 3), wrong(marks, MARKS, 12, 3),
        wrong(marks, MARKS, 20, 3), wrong(marks, FEW, 12, 3));
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    print_header(
        &e,
        "name percent rarer last counter history_12 history_20 few_12");
    for (int percent = 0; percent <= 100; percent += 10)
        print_row(percent);
}
