// Reads the parameters, heads the table and prints its rows. A row that
// cannot be written ends the program at once: a table that took an hour
// is not lost without a word at its end.
#include "common/experiment.h"
#include "common/min_max.h"
#include "common/report.h"
#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <stdarg.h>

struct experiment experiment_begin(int argc, char **argv)
{
    const char *slash = argc > 0 ? strrchr(argv[0], '/') : NULL;
    fail_as(slash ? slash + 1 : argc > 0 ? argv[0] : "experiment");
    return (struct experiment){argc, 1, argv};
}

uint32_t parameter(struct experiment *experiment, const char *name,
                   uint32_t usual, uint32_t min, uint32_t max)
{
    if (experiment->next >= experiment->argc)
        return MIN(usual, max);
    const char *text = experiment->argv[experiment->next++];
    char *end;
    double number = strtod(text, &end);
    bool whole = end > text && !*end && number == floor(number);
    if (!whole || number < min || number > max)
        fail("expected %s from %" PRIu32 " to %" PRIu32
             ", found \"%s\"",
             name, min, max, text);
    return (uint32_t)number;
}

void print_header(const struct experiment *experiment,
                  const char *names)
{
    static const char *const endings[] = {"", "_q1", "_q3", "_min",
                                          "_max"};
    if (experiment->next < experiment->argc)
        fail("expected no more arguments, found \"%s\"",
             experiment->argv[experiment->next]);
    report_provenance(stdout);
    for (const char *name = names; *name;) {
        int length = (int)strcspn(name, ": ");
        const char *behind = name + length;
        int cells = *behind == ':' ? behind[1] - '0' : 1;
        for (int k = 0; k < cells; k++)
            printf("%s%.*s%s", name == names && k == 0 ? "" : "\t",
                   length, name, endings[k]);
        name += strcspn(name, " ");
        name += *name == ' ';
    }
    row_end();
}

static void print_cells(const char *format, va_list arguments)
{
    char cells[1000];
    vsnprintf(cells, sizeof cells, format, arguments);
    for (char *c = cells; isalpha(*cells) && *c && *c != '\t'; c++)
        if (*c == '-')
            *c = '_';
    fputs(cells, stdout);
}

void row_begin(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_cells(format, arguments);
    va_end(arguments);
}

void row_cells(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
}

void row_end(void)
{
    putchar('\n');
    if (fflush(stdout) != 0)
        fail("cannot write standard output: %s", strerror(errno));
}

void row(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_cells(format, arguments);
    va_end(arguments);
    row_end();
}

void row_times(const struct summary *summary, double divisor)
{
    printf("\t%.4g\t%.4g\t%.4g", summary->median / divisor,
           summary->q1 / divisor, summary->q3 / divisor);
}

void row_spread(const struct summary *summary)
{
    printf("\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g", summary->median,
           summary->q1, summary->q3, summary->min, summary->max);
}

void row_of_times(const struct trial *trials, int count, double divisor,
                  const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_cells(format, arguments);
    va_end(arguments);
    for (int k = 0; k < count; k++)
        row_times(&trials[k].summary, divisor);
    row_end();
}

static struct taken {
    void *memory;
    struct taken *before;
} * last_taken;

static void *keep(void *memory)
{
    struct taken *taken = allocate(1, sizeof *taken);
    *taken = (struct taken){memory, last_taken};
    last_taken = taken;
    return memory;
}

void *take(size_t count, size_t size)
{
    return keep(memset(allocate(count, size), 0, count * size));
}

void forget(void)
{
    while (last_taken) {
        struct taken *taken = last_taken;
        last_taken = taken->before;
        free(taken->memory);
        free(taken);
    }
}

struct question kind_question(const char *kind, uint32_t n,
                              uint64_t seed)
{
    struct points points = generate(find_distribution(kind), n, seed);
    keep(points.x); // with y: one block
    return (struct question){points, {STANDARD, 1, 1}, .threads = 1};
}

struct question uniform_question(enum geometry geometry, uint32_t n,
                                 uint64_t seed)
{
    struct question question = kind_question("uniform", n, seed);
    question.space.geometry = geometry;
    return question;
}

struct answers *new_answers(uint32_t n, unsigned given)
{
    struct answers *answers = take(1, sizeof *answers);
    if (given & NEAREST) {
        answers->nearest = take(n, sizeof *answers->nearest);
        answers->nearest2 = take(n, sizeof *answers->nearest2);
    }
    if (given & FURTHEST) {
        answers->furthest = take(n, sizeof *answers->furthest);
        answers->furthest2 = take(n, sizeof *answers->furthest2);
    }
    return answers;
}

struct search {
    search_function *search;
    struct question question;
    struct answers *answers;
};

static void run_search(void *context)
{
    struct search *search = context;
    search->search(&search->question, search->answers);
}

struct trial search_trial(search_function *search,
                          const struct question *question,
                          struct answers *answers)
{
    struct search *kept = take(1, sizeof *kept);
    *kept = (struct search){search, *question, answers};
    return (struct trial){.work = run_search, .context = kept};
}

uint32_t next_size(uint32_t n)
{
    uint32_t power = 1;
    while (n / power >= 10)
        power *= 10;
    return (n / power < 3 ? 3 : 10) * power;
}
