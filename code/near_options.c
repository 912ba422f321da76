//> Understand near's command line
// See near_options.h. Numbers are taken strictly: nothing may follow
// them, and a count must be a whole number in its range.
#include "near_options.h"
#include "common/fail.h"
#include "common/isa.h"
#include <ctype.h>
#include <errno.h>
#include <getopt.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

//> List what can be named
static const char *names_of_geometries(unsigned set)
{
    return set == STANDARD     ? "standard"
           : set == WRAPAROUND ? "wraparound"
                               : "both";
}

static const char *names_of_answers(unsigned set)
{
    return set == NEAREST    ? "nearest"
           : set == FURTHEST ? "furthest"
                             : "both";
}

void print_list(void)
{
    printf("%-18s %2s %-10s %-8s %-5s %s\n", "algorithm", "ch",
           "geometry", "answers", "cost", "what it does");
    for (int row = 0; row < algorithm_count; row++) {
        const struct algorithm *a = &algorithms[row];
        printf("%-18s %2d %-10s %-8s %-5s %s\n", a->name, a->chapter,
               names_of_geometries(a->geometries),
               names_of_answers(a->answers), a->cost, a->about);
    }
    printf("\n%s\n", "distribution");
    for (int row = 0; row < distribution_count; row++)
        printf("%-18s %s\n", distributions[row].name,
               distributions[row].about);
}
//<

//> Take a number strictly
static double parse_count(const char *option, const char *text,
                          double least, double most)
{
    char *end;
    double number = strtod(text, &end);
    if (!isdigit((unsigned char)*text) ||
        tolower((unsigned char)text[1]) == 'x' || *end ||
        number != floor(number) || number < least || number > most)
        fail("%s: expected a whole number from %.0f to %.0f, found "
             "\"%s\"",
             option, least, most, text);
    return number;
}

static uint64_t parse_seed(const char *text)
{
    char *end;
    errno = 0;
    uint64_t seed = strtoull(text, &end, 10);
    if (!isdigit((unsigned char)*text) || *end || errno)
        fail("-s: expected a whole number below 2^64, found \"%s\"",
             text);
    return seed;
}

// Whether the text is exactly count numbers with commas between them.
static bool parse_numbers(const char *text, double *numbers, int count)
{
    if (strpbrk(text, "xX")) // hexadecimal, says strtod; not we
        return false;
    for (int k = 0; k < count; k++) {
        char *end;
        numbers[k] = strtod(text, &end);
        if (end == text || !isfinite(numbers[k]) ||
            *end != (k < count - 1 ? ',' : 0))
            return false;
        text = end + 1;
    }
    return true;
}
//<

//> Take two columns
static struct columns parse_columns(const char *text)
{
    double numbers[2];
    if (!parse_numbers(text, numbers, 2) || numbers[0] == numbers[1] ||
        numbers[0] < 1 || numbers[1] < 1 || numbers[0] > 1e6 ||
        numbers[1] > 1e6 || numbers[0] != floor(numbers[0]) ||
        numbers[1] != floor(numbers[1]))
        fail("--columns: expected two column numbers such as 2,3, "
             "found \"%s\"",
             text);
    return (struct columns){(int)numbers[0], (int)numbers[1]};
}
//<

//> Take a box
static void parse_box(double box[static 4], const char *text)
{
    if (!parse_numbers(text, box, 4) || !(box[0] < box[2]) ||
        !(box[1] < box[3]) || !isfinite(box[2] - box[0]) ||
        !isfinite(box[3] - box[1]))
        fail("--box: expected X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1 and "
             "finite sides, found \"%s\"",
             text);
}
//<

//> Take a name
static enum geometry parse_geometry(const char *text)
{
    if (strcmp(text, "standard") == 0)
        return STANDARD;
    if (strcmp(text, "wraparound") == 0)
        return WRAPAROUND;
    fail("-g: expected standard or wraparound, found \"%s\"", text);
}

static const struct distribution *parse_distribution(const char *text)
{
    const struct distribution *found = find_distribution(text);
    if (!found)
        fail("-d: there is no distribution \"%s\"; see near --list",
             text);
    return found;
}

static const struct algorithm *parse_algorithm(const char *text)
{
    const struct algorithm *found = find_algorithm(text);
    if (!found)
        fail("-a: there is no algorithm \"%s\"; see near --list", text);
    return found;
}
//<

//> Take every option
enum { COLUMNS = 256, BOX, TIMING, CHECK, LIST, HELP };

static void take_option(struct options *options, int option,
                        char **argv)
{
    switch (option) {
    case 'n':
        options->n = parse_count("-n", optarg, 2, UINT32_MAX);
        break;
    case 'd':
        options->distribution = parse_distribution(optarg);
        break;
    case 's':
        options->seed = parse_seed(optarg);
        break;
    case 'a':
        options->algorithm = parse_algorithm(optarg);
        break;
    case 'g':
        options->geometry = parse_geometry(optarg);
        break;
    case 't':
        options->threads = parse_count("-t", optarg, 1, 1024);
        break;
    case 'r':
        options->trials = parse_count("-r", optarg, 1, 1000000);
        break;
    case 'o':
        if (!*optarg)
            fail("-o: expected the name of a file, or -");
        options->output = optarg;
        break;
    case COLUMNS:
        options->columns = parse_columns(optarg);
        break;
    case BOX:
        parse_box(options->box, optarg);
        options->has_box = true;
        break;
    case TIMING:
        options->timing = true;
        break;
    case CHECK:
        options->check = true;
        break;
    case LIST:
        options->list = true;
        break;
    case HELP:
        options->help = true;
        break;
    case ':':
        fail("%s needs a value; see near --help", argv[optind - 1]);
    default:
        if (optopt != 0 && optopt < COLUMNS)
            fail("what is -%c? See near --help", optopt);
        fail("what is %s? See near --help", argv[optind - 1]);
    }
}
//<

//> Tell whether two names are one file
static bool same_file(const char *a, const char *b)
{
    struct stat one, other;
    return stat(a, &one) == 0 && stat(b, &other) == 0 &&
           one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}
//<

//> Find options that contradict each other
static void check_options(const struct options *o, bool generating)
{
    if (o->file && generating)
        fail("points come from a file or from -n, -d and -s, not from "
             "both");
    if (!o->file && !o->n)
        fail("which points? Name a FILE, or say -n N for random ones; "
             "see near --help");
    if (o->file && o->output && same_file(o->file, o->output))
        fail("-o: %s holds the points; the answers would replace them",
             o->output);
    if (o->columns.x && !o->file)
        fail("--columns is for points from a file");
    if (o->has_box && o->geometry != WRAPAROUND)
        fail("--box is for -g wraparound");
    if (o->algorithm && !(o->algorithm->geometries & o->geometry))
        fail("%s does not know the %s geometry; see near --list",
             o->algorithm->name,
             o->geometry == STANDARD ? "standard" : "wraparound");
    if (o->timing && o->output && strcmp(o->output, "-") == 0)
        fail("--timing and -o - both want standard output");
    isa_chosen(); // fails if NEAR_ISA makes no sense
}
//<

struct options parse_options(int argc, char **argv)
{
    static const struct option names[] = {
        {"columns", required_argument, NULL, COLUMNS},
        {"box", required_argument, NULL, BOX},
        {"timing", no_argument, NULL, TIMING},
        {"check", no_argument, NULL, CHECK},
        {"list", no_argument, NULL, LIST},
        {"help", no_argument, NULL, HELP},
        {0},
    };
    struct options options = {.distribution = &distributions[0],
                              .seed = 1,
                              .geometry = STANDARD,
                              .trials = 1};
    bool generating = false;
    opterr = 0; // the sentences are ours
    for (int option;
         (option = getopt_long(argc, argv, ":n:d:s:a:g:t:r:o:", names,
                               NULL)) != -1;) {
        take_option(&options, option, argv);
        generating |= option == 'n' || option == 'd' || option == 's';
    }
    if (argc - optind > 1)
        fail("one FILE at a time, please: \"%s\" and \"%s\" are two",
             argv[optind], argv[optind + 1]);
    options.file = argv[optind];
    if (!options.list && !options.help)
        check_options(&options, generating);
    return options;
}
//<
