// One option after the other, then what they say together: what
// contradicts itself is refused before any work is done.
#include "near/options.h"
#include "common/fail.h"
#include "common/isa.h"
#include "near/threads.h"
#include "near/values.h"
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { COLUMNS = 256, BOX, WITHIN, COUNTS, TIMING, CHECK, LIST, HELP };

static _Noreturn void refuse_option(int option, char **argv)
{
    if (option == ':')
        fail("%s needs a value; see near --help", argv[optind - 1]);
    if (optopt != 0 && optopt < COLUMNS)
        fail("what is -%c? See near --help", optopt);
    fail("what is %s? See near --help", argv[optind - 1]);
}

static void take_neighbors_option(struct options *options, int option,
                                  char **argv)
{
    switch (option) {
    case 'k':
        options->k = parse_count("-k", optarg, 1, UINT32_MAX);
        break;
    case WITHIN:
        options->distance = parse_distance("--within", optarg);
        options->within = true;
        break;
    case COUNTS:
        options->counts = true;
        break;
    default:
        refuse_option(option, argv);
    }
}

static void take_long_option(struct options *options, int option,
                             char **argv)
{
    switch (option) {
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
    default:
        take_neighbors_option(options, option, argv);
    }
}

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
        options->threads = parse_count("-t", optarg, 1, MAX_THREADS);
        break;
    case 'r':
        options->trials = parse_count("-r", optarg, 1, 1000000);
        break;
    case 'o':
        if (!*optarg)
            fail("-o: expected the name of a file, or -");
        options->output = optarg;
        break;
    default:
        take_long_option(options, option, argv);
    }
}

// The first may be "-", which is the file at standard input, if it is
// one.
static bool same_file(const char *input, const char *output)
{
    struct stat in, out;
    bool from_stdin = strcmp(input, "-") == 0;
    int found =
        from_stdin ? fstat(STDIN_FILENO, &in) : stat(input, &in);
    return found == 0 && stat(output, &out) == 0 &&
           (!from_stdin || S_ISREG(in.st_mode)) &&
           in.st_dev == out.st_dev && in.st_ino == out.st_ino;
}

static void check_neighbors_options(const struct options *o)
{
    if (o->k && o->within)
        fail("one of -k and --within at a time");
    if ((o->k || o->within) && o->algorithm)
        fail("-a is for one nearest and one furthest neighbor; -k and "
             "--within are answered in a way of their own");
    if (o->counts && !o->within)
        fail("--counts is for --within");
}

static void check_options(const struct options *o, bool generating)
{
    if (o->file && generating)
        fail("points come from a file or from -n, -d and -s, not from "
             "both");
    if (!o->file && !o->n)
        fail("which points? Name a FILE, or say -n N for random ones; "
             "see near --help");
    if (o->file && !*o->file)
        fail("expected the name of a file, found \"\"");
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
    check_neighbors_options(o);
    isa_chosen(); // fails if NEAR_ISA makes no sense
}

struct options parse_options(int argc, char **argv)
{
    static const struct option names[] = {
        {"columns", required_argument, NULL, COLUMNS},
        {"box", required_argument, NULL, BOX},
        {"within", required_argument, NULL, WITHIN},
        {"counts", no_argument, NULL, COUNTS},
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
         (option = getopt_long(argc, argv, ":n:d:s:a:g:k:t:r:o:", names,
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
