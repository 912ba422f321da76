// Files as people have them, good and bad.
#include "reader.h"
#include "common/fail.h"
#include "common/lines.h"
#include "common/read_points.h"
#include "harness.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// A file with this content; its name is put into name.
struct file {
    char name[40];
    struct columns columns;
    int threads;
};

static struct file make_file(const char *text, size_t size)
{
    struct file file = {"/tmp/near-test-XXXXXX", {0, 0}, 1};
    int descriptor = mkstemp(file.name);
    if (descriptor < 0 ||
        write(descriptor, text, size) != (ssize_t)size)
        fail("cannot make a file to test with");
    close(descriptor);
    return file;
}

static void read_it(void *context)
{
    struct file *file = context;
    struct points points =
        read_points(file->name, file->columns, file->threads);
    points_free(&points);
}

// ---- good files ----------------------------------------------------
static void check_points(const char *text, struct columns columns,
                         uint32_t n, const double (*expected)[2])
{
    struct file file = make_file(text, strlen(text));
    struct points points = read_points(file.name, columns, 1);
    CHECK_INT(n, points.n, "points in \"%s\"", text);
    for (uint32_t i = 0; i < n && i < points.n; i++) {
        CHECK_DOUBLE(expected[i][0], points.x[i], "x %u of \"%s\"",
                     (unsigned)i, text);
        CHECK_DOUBLE(expected[i][1], points.y[i], "y %u of \"%s\"",
                     (unsigned)i, text);
    }
    points_free(&points);
    unlink(file.name);
}

void good_tables_are_read(void)
{
    static const double points[][2] = {{1, 2.5}, {-3e2, 0.1}};
    static const char *const texts[] = {
        "1 2.5\n-3e2 .1\n",
        "1 2.5\n-3e2 .1",
        "1 2.5\r\n-3e2 .1\r\n",
        "1\t2.5\n-3e2\t.1\n",
        "1,2.5\n-3e2,.1\n",
        "1, 2.5\n-3e2 , .1 \n",
        "1;2.5\n-3e2; .1\n",
        " 1 \t 2.5 \n\n\t\n  -3e2 \t   .1\n\n",
        " 1   2.5 \n\n\t\n\t-3e2 \t   .1\n\n",
        "# a comment\n1 2.5 # and another\n#\n-3e2 .1\n",
        "x y\n1 2.5\n-3e2 .1\n",
        "\"x\",\"y\"\n1,2.5\n-3e2,.1\n",
        "# made by hand\n\nlongitude;latitude\n1;2.5\n-3e2;.1\n",
        "\xef\xbb\xbfx,y\n1,2.5\n-3e2,.1\n",
        "\357\273\2771,2.5\n-3e2,.1\n",
        "+1 0002.50\n-300. 1e-1\n",
    };
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++)
        check_points(texts[k], (struct columns){0, 0}, 2, points);
    check_points("X:,Y:\n1,2.5\n-3e2,.1\n", (struct columns){0, 0}, 2,
                 points);
    check_points("x.1 \xce\xbc\n1 2.5\n-3e2 .1\n",
                 (struct columns){0, 0}, 2, points);
    check_points("1 2.5 rest\n-3e2 .1 rest\n", (struct columns){1, 2},
                 2, points);
    check_points("name,y,x\nAnn,2.5,1\nBob,.1,-3e2\n",
                 (struct columns){3, 2}, 2, points);
    check_points("id\tlabel\tx\ty\tz\n7\t\t1\t2.5\t\n"
                 "8\tArea 51\t-3e2\t.1\t9\n",
                 (struct columns){3, 4}, 2, points);
    check_points("\"a, b #1\",1,2.5 # c\n\"New York\",-3e2,.1\n",
                 (struct columns){2, 3}, 2, points);
    check_points("Ulm;;1;2.5\nRom;;-3e2;.1\n", (struct columns){3, 4},
                 2, points);
}

void good_tsplib_files_are_read(void)
{
    static const double points[][2] = {{1, 2.5}, {-3e2, 0.1}};
    static const char *const texts[] = {
        "NAME: two\nDIMENSION: 2\nNODE_COORD_SECTION\n"
        "1 1 2.5\n2 -3e2 .1\nEOF\n",
        "NAME : two\nCOMMENT : 7 8\nTYPE : TSP\nDIMENSION : 2\n"
        "EDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n"
        " 1 1 2.5\n 2 -3e2 .1\n",
        "NAME: two\r\nDIMENSION:2\r\nNODE_COORD_SECTION :\r\n"
        "1\t1\t2.5\r\n2\t-3.0e+02\t1.0e-01\r\nEOF\r\nany thing\r\n",
        "DIMENSION: 2\nNODE_COORD_SECTION\n1 1 2.5\n2 -3e2 .1\n-1\n",
        "DIMENSION: 2\nNODE_COORD_SECTION\n1 1 2.5\n2 -3e2 .1\n"
        "DISPLAY_DATA_SECTION\n1 7 7\n2 8 8\nEOF",
    };
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++)
        check_points(texts[k], (struct columns){0, 0}, 2, points);
}

// ---- bad files -----------------------------------------------------
struct bad {
    const char *text;
    struct columns columns;
    const char *sentence; // after the file's name
};

static void check_refusals(const struct bad *bad, int n)
{
    for (int k = 0; k < n; k++) {
        struct file file = make_file(bad[k].text, strlen(bad[k].text));
        char sentence[200];
        file.columns = bad[k].columns;
        snprintf(sentence, sizeof sentence, "%s:%s", file.name,
                 bad[k].sentence);
        CHECK_FAILS(sentence, read_it, &file, "\"%s\"", bad[k].text);
        unlink(file.name);
    }
}

#define COUNT_OF(array) (int)(sizeof array / sizeof *array)

void bad_tables_are_refused(void)
{
    static const struct bad bad[] = {
        {"1,2\n12.5,abc\n",
         {0, 0},
         "2: expected two numbers, found \"12.5,abc\"\n"},
        {"1 2\n\n# c\n3 4x\n",
         {0, 0},
         "4: expected two numbers, found \"3 4x\"\n"},
        {"12.5x,3.1y\n", {0, 0}, "1: expected two numbers, found \"12"},
        {"x,2\n1,2\n", {0, 0}, "1: expected two numbers, found \"x,2"},
        {"1\n2\n", {0, 0}, "1: expected two numbers, found \"1\""},
        {"1 2\n3\n", {0, 0}, "2: expected two numbers, found \"3\""},
        {"1,\n", {0, 0}, "1: expected two numbers, found \"1,\""},
        {",1,2\n",
         {0, 0},
         "1: expected two numbers (or --columns I,J)"},
        {"Berlin,52.5,13.4\n",
         {0, 0},
         "1: expected two numbers (or --columns I,J), found \"Ber"},
        {"NA,NA\n1,2\n", {0, 0}, "1: expected two numbers, found \"NA"},
        {"\"1\",\"2\"\n3,4\n", {0, 0}, "1: expected two numbers"},
        {"1,2\n3,\v0x2\n", {0, 0}, "2: expected text, found a binary"},
        {"1 2\r3 4\n", {0, 0}, "1: expected text, found a binary"},
        {"1,5;2\n", {0, 0}, "1: expected two numbers, found \"1,5;2\""},
        {"1 2 3\n", {0, 0}, "1: expected two columns (or --columns"},
        {"x y\nx y\n",
         {0, 0},
         "2: expected two numbers, found \"x y\""},
        {"nan 1\n",
         {0, 0},
         "1: expected finite numbers, found \"nan 1"},
        {"nan,nan\n",
         {0, 0},
         "1: expected finite numbers, found \"nan"},
        {"1 -inf\n",
         {0, 0},
         "1: expected finite numbers, found \"1 -i"},
        {"1e999 1\n",
         {0, 0},
         "1: expected finite numbers, found \"1e9"},
        {"0x10 1\n", {0, 0}, "1: expected two numbers, found \"0x10 1"},
        {"1 2\n1 --2\n",
         {0, 0},
         "2: expected two numbers, found \"1 -"},
        {"1 2\x01\n", {0, 0}, "1: expected text, found a binary file"},
        {"", {0, 0}, " expected points, found none"},
        {"# nothing\n\n", {0, 0}, " expected points, found none"},
        {"x y\n", {0, 0}, " expected points, found none"},
        {"1\t2\n3\t\t4\n",
         {0, 0},
         "2: expected two numbers, found \"3\t\t4\""},
        {"1\t2\n3 4\n",
         {0, 0},
         "2: expected two numbers, found \"3 4\""},
        {"1e-400 0\n",
         {0, 0},
         "1: expected numbers that a double can tell from 0, found"},
        {"1 2\n0 -0.00003e-330\n",
         {0, 0},
         "2: expected numbers that a double can tell from 0, found"},
        {"\xe2\x88\x92"
         "1 \xe2\x88\x92"
         "2\n3 4\n",
         {0, 0},
         "1: expected two numbers, found"},
        {"\xef\xbc\x91 \xef\xbc\x92\n3 4\n",
         {0, 0},
         "1: expected two numbers, found"},
        {"None,none\n3,4\n",
         {0, 0},
         "1: expected two numbers, found \"None,none"},
        {"l.5,S.2\n3,4\n",
         {0, 0},
         "1: expected two numbers, found \"l.5,S.2"},
        {"a,1,2\nb,1\n",
         {2, 3},
         "2: expected 3 fields, as in line 1, found \"b,1\"\n"},
        {"a,1,2\nb,1,2,3\n",
         {2, 3},
         "2: expected 3 fields, as in line 1, found \"b,1,2,3\"\n"},
        {"1 2 rest\n3 4\n",
         {1, 2},
         "2: expected 3 fields, as in line 1, found \"3 4\""},
        {"label\tx\ty\nArea 51\t1\n",
         {2, 3},
         "2: expected 3 fields, as in line 1, found \"Area 51"},
        {"# c\na,x,y\nb,1,\n",
         {2, 3},
         "3: expected numbers in the two columns, found \"b,1,\""},
        {"a,1,2\n", {1, 2}, "1: expected numbers in the two columns"},
    };
    check_refusals(bad, COUNT_OF(bad));

    for (size_t length = LONGEST_LINE - 2; length < LONGEST_LINE;
         length++) { // of the first line, with its end
        char *text = memset(allocate(length + 5, 1), 'x', length);
        memcpy(text, "1 2 #", 5);
        strcpy(text + length - 1, "\n3 4\n");
        struct file file = make_file(text, strlen(text));
        if (length == LONGEST_LINE - 2)
            read_it(&file);
        else
            CHECK_FAILS(":1: expected text, found a line without end",
                        read_it, &file, "%zu bytes", length);
        unlink(file.name);
        free(text);
    }

    struct file zeros = make_file("1 2\n\0\0\0\n", 8);
    CHECK_FAILS(":2: expected text, found a binary file", read_it,
                &zeros, "zero bytes");
    unlink(zeros.name);
}

void bad_tsplib_files_are_refused(void)
{
    static const struct bad bad[] = {
        {"NAME: cut\nDIMENSION: 3\nNODE_COORD_SECTION\n1 1 1\n2 2 2\n",
         {0, 0},
         "5: expected 3 points, as DIMENSION says, found 2\n"},
        {"NAME: cut\nDIMENSION: 2\nNODE_COORD_SECTION\n1 1 1\n2 2 2",
         {0, 0},
         "5: expected 2 points, as DIMENSION says, found 2, the last"},
        {"NAME: cut\nDIMENSION: 3\nNODE_COORD_SECTION\n1 1 1\n2 2",
         {0, 0},
         "5: expected a point's number and its two coordinates, found"},
        {"NAME: cut\nDIMENSION: 1\nNODE_COORD_SECTION\n1 1 1\n2 2 2\n",
         {0, 0},
         "5: expected 1 points, as DIMENSION says, found 2\n"},
        {"NAME: 3d\nDIMENSION: 1\nNODE_COORD_SECTION\n1 1 1 1\n",
         {0, 0},
         "4: expected a point's number and its two coordinates, found"},
        {"NAME: x\nDIMENSION: many\nNODE_COORD_SECTION\n1 1 1\n",
         {0, 0},
         "2: expected the number of points, found \"DIMENSION: many\""},
        {"NAME: x\nNODE_COORD_SECTION\n1 1 1\n",
         {0, 0},
         " expected a DIMENSION, found none"},
        {"NAME: x\nDIMENSION: 1\n",
         {0, 0},
         " expected a NODE_COORD_SECTION, found none"},
        {"NAME: x\nDIMENSION: 1\nNODE_COORD_SECTION\n1 1 nan\n",
         {0, 0},
         "4: expected finite numbers, found \"1 1 nan\""},
    };
    check_refusals(bad, COUNT_OF(bad));
}

void no_file_at_all_is_refused(void)
{
    struct file missing = {"/no/such/file", {0, 0}, 1};
    struct file folder = {"/tmp", {0, 0}, 1};
    CHECK_FAILS("cannot open /no/such/file: No such file", read_it,
                &missing, "a missing file");
    CHECK_FAILS("cannot read /tmp: Is a directory", read_it, &folder,
                "a folder");
}

// Enough for the arrays to grow several times, and for four threads.
enum { many = 60000 };

static size_t write_many(char *text)
{
    size_t size = 0;
    for (int i = 0; i < many; i++)
        size += sprintf(text + size, "%.17g,%.17g\n", sqrt(i),
                        -1. / (i + 1));
    return size;
}

void many_points_are_read(void)
{
    char *text = malloc(many * 64);
    struct file file = make_file(text, write_many(text));
    for (int threads = 1; threads <= 4; threads++) {
        struct points points =
            read_points(file.name, file.columns, threads);
        CHECK_INT(many, points.n, "points");
        for (uint32_t i = 0; i < points.n; i++)
            if (!CHECK_DOUBLE(sqrt(i), points.x[i], "x %u",
                              (unsigned)i) ||
                !CHECK_DOUBLE(-1. / (i + 1), points.y[i], "y %u",
                              (unsigned)i))
                break;
        points_free(&points);
    }
    unlink(file.name);
    free(text);
}

// Of two bad lines the first is named, whichever thread has it. To be
// run before this process has threads: its copies would miss them.
void the_first_bad_line_is_named(void)
{
    char *text = malloc(many * 64);
    const size_t size = write_many(text);
    for (int k = 0; k < 8; k++) {
        char *bad = text + size / 8 * k;
        size_t line = 1;
        for (char *c = text; c < bad; c++)
            line += *c == '\n';
        char before = *bad;
        bool first_of_line = bad == text || bad[-1] == '\n';
        if (before == '\n' || first_of_line)
            bad++, before = *bad;
        *bad = k % 2 ? 'x' : '\1';
        text[size - 2] = 'y';
        struct file file = make_file(text, size);
        for (file.threads = 1; file.threads <= 4; file.threads++) {
            char sentence[100];
            snprintf(sentence, sizeof sentence, "%s:%zu: expected %s",
                     file.name, line,
                     k % 2 ? "two numbers" : "text, found a binary");
            CHECK_FAILS(sentence, read_it, &file, "%d threads",
                        file.threads);
        }
        unlink(file.name);
        *bad = before;
    }
    free(text);
}
