// Writes what a course's machine wants to read: Gradescope's
// results.json, JUnit's XML, and on standard output the table and
// Autolab's last line.
//
//   results FOLDER NOTE [KEY TITLE WORTH SCORES REPORT]...
//
// WORTH is how many points an exercise gives, SCORES its table, REPORT
// the file of what was said about it. Both files hold words of the
// student's program. Whatever it printed, what we write is valid: bytes
// that are no UTF-8 become U+FFFD, control characters a question mark.
#include <errno.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_MAX = 60000, ROW_MAX = 1 << 16, TESTS_MAX = 64 };

enum column {
    TEST,
    POINTS,
    OF,
    STATUS,
    ABOUT,
    SEED,
    GIVEN,
    WHERE,
    EXPECTED,
    FOUND,
    CAUSE,
    RATIO,
    COLUMNS
};

struct test {
    char *cell[COLUMNS];
    int points, of;
};

struct exercise {
    const char *key, *title;
    struct test tests[TESTS_MAX];
    int count, points, of, worth;
    char *report;
};

static _Noreturn void die(const char *what, const char *name)
{
    fprintf(stderr, "results: %s %s: %s\n", what, name,
            errno ? strerror(errno) : "it is no table of scores");
    exit(2);
}

// ---- text that is safe everywhere ----------------------------------

// How many bytes the character at text takes in UTF-8; 0 if it is none,
// or one that XML does not allow.
static int character(const unsigned char *text)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    int length = text[0] < 0x80         ? 1
                 : text[0] >> 5 == 0x06 ? 2
                 : text[0] >> 4 == 0x0e ? 3
                 : text[0] >> 3 == 0x1e ? 4
                                        : 0;
    if (length <= 1)
        return length;
    uint32_t code = text[0] & (0xff >> (length + 1));
    for (int k = 1; k < length; k++) {
        if (text[k] >> 6 != 2)
            return 0;
        code = code << 6 | (text[k] & 0x3f);
    }
    bool good = code >= least[length] && code <= 0x10ffff &&
                code >> 11 != 0x1b && code != 0xfffe && code != 0xffff;
    return good ? length : 0;
}

// Writes text with its characters replaced as json or XML demands.
static void put_text(FILE *file, const char *text, bool json)
{
    const unsigned char *c = (const unsigned char *)text;
    while (c && *c) {
        int length = character(c);
        if (length == 0)
            fputs("\xef\xbf\xbd", file);
        else if (length > 1)
            fwrite(c, 1, length, file);
        else if (*c == '\n')
            fputs(json ? "\\n" : "&#10;", file);
        else if (*c < ' ' || *c == 0x7f)
            putc(*c == '\t' ? ' ' : '?', file);
        else if (json && (*c == '"' || *c == '\\'))
            fprintf(file, "\\%c", *c);
        else if (!json && strchr("<>&\"'", *c))
            fprintf(file, "&#%d;", *c);
        else
            putc(*c, file);
        c += length > 0 ? length : 1;
    }
}

static void put_json(FILE *file, const char *name, const char *text)
{
    fprintf(file, "\"%s\": \"", name);
    put_text(file, text, true);
    putc('"', file);
}

// ---- what is read --------------------------------------------------

static char *copy(const char *text)
{
    char *kept = strdup(text);
    if (!kept)
        die("no memory for", "a report");
    return kept;
}

static void split(char *row, struct test *test)
{
    row[strcspn(row, "\n")] = '\0';
    for (int k = 0; k < COLUMNS; k++) {
        size_t length = strcspn(row, "\t");
        bool last = row[length] == '\0';
        row[length] = '\0';
        test->cell[k] = copy(row);
        row += length + !last;
    }
    test->points = atoi(test->cell[POINTS]);
    test->of = atoi(test->cell[OF]);
}

static void read_scores(struct exercise *exercise, const char *name)
{
    static char row[ROW_MAX];
    FILE *file = fopen(name, "r");
    if (!file || !fgets(row, sizeof row, file))
        die("cannot read", name);
    errno = 0;
    while (fgets(row, sizeof row, file)) {
        if (exercise->count == TESTS_MAX || !strchr(row, '\n'))
            die("cannot read", name);
        struct test *test = &exercise->tests[exercise->count++];
        split(row, test);
        exercise->points += test->points;
        exercise->of += test->of;
    }
    if (ferror(file))
        die("cannot read", name);
    fclose(file);
}

// The head of a long report, and its tail, where the table is.
static void read_report(struct exercise *exercise, const char *name)
{
    FILE *file = fopen(name, "r");
    if (!file)
        die("cannot read", name);
    char *text = malloc(TEXT_MAX + 1);
    if (!text)
        die("no memory for", name);
    char *tail = text + TEXT_MAX / 2;
    size_t length = fread(text, 1, TEXT_MAX, file);
    if (length == TEXT_MAX &&
        fseek(file, -(TEXT_MAX / 2), SEEK_END) == 0) {
        memcpy(tail - 5, "\n...\n", 5);
        length = TEXT_MAX / 2 + fread(tail, 1, TEXT_MAX / 2, file);
    }
    for (size_t k = 0; k < length; k++)
        text[k] = text[k] ? text[k] : '?';
    text[length] = '\0';
    exercise->report = text;
    fclose(file);
}

// ---- what is written -----------------------------------------------

static bool passed(const struct test *test)
{
    return strcmp(test->cell[STATUS], "passed") == 0;
}

static bool graded(const struct test *test)
{
    return strcmp(test->cell[STATUS], "not graded") != 0;
}

// Lost with all others, because of the file.
static bool untested(const struct test *test)
{
    return !passed(test) && *test->cell[SEED] == '\0';
}

// What a test says, in lines; why nothing was tested, only the first.
static char *said(const struct test *test, bool first)
{
    static char text[TEXT_MAX];
    const char *labels[COLUMNS] = {
        [GIVEN] = "input", [WHERE] = "where", [EXPECTED] = "expected",
        [FOUND] = "found", [CAUSE] = "why",   [SEED] = "seed"};
    text[0] = '\0';
    if (passed(test))
        return text;
    size_t length =
        snprintf(text, sizeof text, "%s\n", test->cell[STATUS]);
    if (untested(test) && !first)
        return text;
    for (int k = SEED; k <= CAUSE; k++)
        if (*test->cell[k] && length < sizeof text)
            length += snprintf(text + length, sizeof text - length,
                               "%s: %s\n", labels[k], test->cell[k]);
    return text;
}

// Points that could not be graded are no loss: the others count for
// them in proportion.
static double score(const struct exercise *exercise)
{
    if (exercise->of == 0)
        return 0;
    return (double)exercise->points * exercise->worth / exercise->of;
}

static FILE *begin(const char *folder, const char *name)
{
    static char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    if (!file)
        die("cannot write", path);
    return file;
}

static void end(FILE *file, const char *name)
{
    bool bad = ferror(file);
    if (fclose(file) != 0 || bad)
        die("cannot write", name);
}

static void write_json_test(FILE *file, const struct exercise *exercise,
                            int t, bool last)
{
    const struct test *test = &exercise->tests[t];
    fprintf(
        file,
        "    {\"score\": %d, \"max_score\": %d, \"status\": \"%s\", "
        "\"visibility\": \"visible\",\n      ",
        test->points, test->of,
        passed(test) || !graded(test) ? "passed" : "failed");
    fprintf(file, "\"number\": \"%s.%d\", ", exercise->key, t + 1);
    char name[512];
    snprintf(name, sizeof name, "%s %s: %s", exercise->key,
             exercise->title, test->cell[ABOUT]);
    put_json(file, "name", name);
    fputs(",\n      ", file);
    put_json(file, "output", said(test, t == 0));
    fputs(",\n      \"extra_data\": {", file);
    put_json(file, "exercise", exercise->key);
    fputs(", ", file);
    put_json(file, "test", test->cell[TEST]);
    fputs(", ", file);
    put_json(file, "verdict", test->cell[STATUS]);
    fputs(", ", file);
    put_json(file, "seed", test->cell[SEED]);
    fprintf(file, "}}%s\n", last ? "" : ",");
}

// Only who is right may be fast: all other tests have passed.
static bool has_place(const struct exercise *exercise)
{
    bool right = true;
    for (int t = 0; t < exercise->count; t++) {
        const struct test *test = &exercise->tests[t];
        right &= *test->cell[RATIO] || passed(test) || !graded(test);
    }
    return right;
}

// The time of each race, as a multiple of the reference's.
static void write_leaderboard(FILE *file,
                              const struct exercise *exercises,
                              int count)
{
    int entries = 0;
    for (int e = 0; e < count; e++)
        for (int t = 0; t < exercises[e].count; t++) {
            const struct test *test = &exercises[e].tests[t];
            char name[512];
            if (!*test->cell[RATIO] || !has_place(&exercises[e]))
                continue;
            snprintf(name, sizeof name, "%s %s: %s", exercises[e].key,
                     exercises[e].title, test->cell[ABOUT]);
            fputs(entries++ ? ",\n    {"
                            : "  \"leaderboard\": [\n    {",
                  file);
            put_json(file, "name", name);
            fprintf(file, ", \"value\": %s, \"order\": \"asc\"}",
                    test->cell[RATIO]);
        }
    if (entries > 0)
        fputs("\n  ],\n", file);
}

static void write_json(const char *folder, const char *note,
                       const struct exercise *exercises, int count)
{
    FILE *file = begin(folder, "results.json");
    double total = 0;
    for (int e = 0; e < count; e++)
        total += score(&exercises[e]);
    fprintf(file, "{\n  \"score\": %.2f,\n  \"output\": \"", total);
    put_text(file, note, true);
    for (int e = 0; e < count; e++) {
        put_text(file, exercises[e].report, true);
        put_text(file, "\n", true);
    }
    fputs("\",\n  \"visibility\": \"visible\",\n"
          "  \"stdout_visibility\": \"hidden\",\n"
          "  \"extra_data\": {",
          file);
    for (int e = 0; e < count; e++)
        fprintf(file, "%s\"%s\": {\"points\": %d, \"of\": %d}",
                e > 0 ? ", " : "", exercises[e].key,
                exercises[e].points, exercises[e].of);
    fputs("},\n", file);
    write_leaderboard(file, exercises, count);
    fputs("  \"tests\": [\n", file);
    for (int e = 0; e < count; e++)
        for (int t = 0; t < exercises[e].count; t++)
            write_json_test(file, &exercises[e], t,
                            e == count - 1 &&
                                t == exercises[e].count - 1);
    fputs("  ]\n}\n", file);
    end(file, "results.json");
}

static void write_case(FILE *file, const struct exercise *exercise,
                       int t)
{
    const struct test *test = &exercise->tests[t];
    fprintf(file, "    <testcase classname=\"%s\" name=\"",
            exercise->key);
    put_text(file, test->cell[TEST], false);
    fputs("\">", file);
    if (!passed(test)) {
        const char *kind = graded(test) ? "failure" : "skipped";
        fprintf(file, "<%s message=\"", kind);
        put_text(file, said(test, t == 0), false);
        fputs("\"/>", file);
    }
    fputs("</testcase>\n", file);
}

static void write_suite(FILE *file, const struct exercise *exercise)
{
    int failures = 0, skipped = 0;
    for (int t = 0; t < exercise->count; t++) {
        skipped += !graded(&exercise->tests[t]);
        failures +=
            graded(&exercise->tests[t]) && !passed(&exercise->tests[t]);
    }
    fprintf(file, "  <testsuite name=\"%s ", exercise->key);
    put_text(file, exercise->title, false);
    fprintf(file,
            "\" tests=\"%d\" failures=\"%d\" errors=\"0\" "
            "skipped=\"%d\">\n",
            exercise->count, failures, skipped);
    for (int t = 0; t < exercise->count; t++)
        write_case(file, exercise, t);
    fputs("  </testsuite>\n", file);
}

static void write_xml(const char *folder,
                      const struct exercise *exercises, int count)
{
    FILE *file = begin(folder, "junit.xml");
    fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n",
          file);
    for (int e = 0; e < count; e++)
        write_suite(file, &exercises[e]);
    fputs("</testsuites>\n", file);
    end(file, "junit.xml");
}

// A test that was lost stands in the table, a file that could not be
// tested only once.
static void print_exercise(const struct exercise *exercise)
{
    printf("  %-6s %-48s %3d / %d\n", exercise->key, exercise->title,
           exercise->points, exercise->of);
    for (int t = 0; t < exercise->count; t++) {
        const struct test *test = &exercise->tests[t];
        if (untested(test)) {
            printf("         %s\n", test->cell[STATUS]);
            break;
        }
        if (!passed(test))
            printf("         %-10s %s\n", test->cell[STATUS],
                   test->cell[ABOUT]);
    }
}

static void print_table(const char *note,
                        const struct exercise *exercises, int count)
{
    int points = 0, of = 0;
    printf("\n");
    for (int e = 0; e < count; e++) {
        print_exercise(&exercises[e]);
        points += exercises[e].points;
        of += exercises[e].of;
    }
    printf("  %-6s %-48s %3d / %d\n\n%s", "", "", points, of, note);
    printf("{\"scores\": {");
    for (int e = 0; e < count; e++)
        printf("%s\"%s\": %.2f", e > 0 ? ", " : "", exercises[e].key,
               score(&exercises[e]));
    printf("}}\n");
}

int main(int argc, char **argv)
{
    enum { EACH = 5, FIRST = 3 };
    if (argc < FIRST || (argc - FIRST) % EACH != 0)
        return 2;
    int count = (argc - FIRST) / EACH;
    struct exercise *exercises = calloc(count + 1, sizeof *exercises);
    if (!exercises)
        die("no memory for", argv[1]);
    for (int e = 0; e < count; e++) {
        char **given = argv + FIRST + e * EACH;
        exercises[e].key = given[0];
        exercises[e].title = given[1];
        exercises[e].worth = atoi(given[2]);
        read_scores(&exercises[e], given[3]);
        read_report(&exercises[e], given[4]);
    }
    write_json(argv[1], argv[2], exercises, count);
    write_xml(argv[1], exercises, count);
    print_table(argv[2], exercises, count);
    if (fflush(stdout) != 0)
        die("cannot print", "the table");
    return 0;
}
