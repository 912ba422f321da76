//> Drive an experiment
// Reads the parameters, heads the table and prints its rows. A row that
// cannot be written ends the program at once: a table that took an hour
// is not lost without a word at its end.
#include "common/experiment.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/report.h"
#include <ctype.h>
#include <errno.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//> Read the parameters of an experiment
struct experiment experiment_begin(int argc, char **argv)
{
    const char *slash = argc > 0 ? strrchr(argv[0], '/') : NULL;
    fail_as(slash ? slash + 1 : argc > 0 ? argv[0] : "experiment");
    return (struct experiment){argc, 1, argv};
}

uint32_t parameter(struct experiment *experiment, const char *name,
                   uint32_t otherwise, uint32_t least, uint32_t most)
{
    if (experiment->next >= experiment->argc)
        return otherwise < most ? otherwise : most;
    const char *text = experiment->argv[experiment->next++];
    char *end;
    double number = strtod(text, &end);
    bool whole = end > text && !*end && number == floor(number);
    if (!whole || number < least || number > most)
        fail("expected %s from %" PRIu32 " to %" PRIu32
             ", found \"%s\"",
             name, least, most, text);
    return (uint32_t)number;
}
//<

//> Head the table
void columns(const struct experiment *experiment, const char *names)
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
//<

//> Print a row
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
//<

//> Print medians and quartiles
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
//<

//> Make a question to experiment with
struct question kind_question(const char *kind, uint32_t n,
                              uint64_t seed)
{
    return (struct question){
        .points = generate(find_distribution(kind), n, seed),
        .space = {STANDARD, 1, 1},
        .threads = 1,
    };
}

struct question uniform_question(enum geometry geometry, uint32_t n,
                                 uint64_t seed)
{
    struct question question = kind_question("uniform", n, seed);
    question.space.geometry = geometry;
    return question;
}

void run_search(void *context)
{
    struct search *search = context;
    search->search(&search->question, search->answers);
}
//<
//<
