// One option after the other, then what they say together.
#include "range/options.h"
#include "common/fail.h"
#include "near/threads.h"
#include "near/values.h"
#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    DIMENSIONS = 256,
    BOX,
    WITHIN_R,
    NEAREST_OF,
    QUERIES,
    RANDOM,
    SHARE,
    COUNTS,
    TIMING,
    CHECK,
    LIST,
    HELP
};

static void wish(struct options *options, enum wish wish)
{
    if (options->wish && options->wish != wish)
        fail("one of --box, --within and --nearest at a time");
    options->wish = wish;
}

static double parse_number(const char *option, const char *text,
                           double most, const char *expected)
{
    char *end;
    const double number = strtod(text, &end);
    if (end == text || *end || strpbrk(text, "xX") ||
        !(number >= 0 && number <= most))
        fail("%s: expected %s, found \"%s\"", option, expected, text);
    return number;
}

static const struct distribution *parse_kind(const char *text)
{
    const struct distribution *found = find_distribution(text);
    if (!found)
        fail("-d: there is no distribution \"%s\"; see range --list",
             text);
    return found;
}

static const struct structure *parse_structure(const char *text)
{
    const struct structure *found = find_structure(text);
    if (!found)
        fail("-a: there is no structure \"%s\"; see range --list",
             text);
    return found;
}

static _Noreturn void refuse(int option, char **argv)
{
    if (option == ':')
        fail("%s needs a value; see range --help", argv[optind - 1]);
    if (optopt != 0 && optopt < DIMENSIONS)
        fail("what is -%c? See range --help", optopt);
    fail("what is %s? See range --help", argv[optind - 1]);
}

static void take_query_option(struct options *o, int option)
{
    switch (option) {
    case BOX:
        wish(o, BOXES);
        break;
    case WITHIN_R:
        wish(o, WITHIN);
        o->distance = parse_number("--within", optarg, HUGE_VAL,
                                   "a distance, 0 or more");
        break;
    case NEAREST_OF:
        wish(o, NEAREST_K);
        o->k = parse_count("--nearest", optarg, 1, UINT32_MAX);
        break;
    case QUERIES:
        o->queries = optarg;
        break;
    case RANDOM:
        o->random = parse_count("--random", optarg, 1, UINT32_MAX);
        break;
    case SHARE:
        o->share =
            parse_number("--share", optarg, 1, "a number from 0 to 1");
        break;
    }
}

static void take_long_option(struct options *o, int option, char **argv)
{
    switch (option) {
    case DIMENSIONS:
        o->dimensions =
            parse_count("--dimensions", optarg, 1, MOST_DIMENSIONS);
        break;
    case COUNTS:
        o->counts = true;
        break;
    case TIMING:
        o->timing = true;
        break;
    case CHECK:
        o->check = true;
        break;
    case LIST:
        o->list = true;
        break;
    case HELP:
        o->help = true;
        break;
    case ':':
    case '?':
        refuse(option, argv);
    default:
        take_query_option(o, option);
    }
}

static void take_option(struct options *o, int option, char **argv)
{
    switch (option) {
    case 'n':
        o->n = parse_count("-n", optarg, 1, UINT32_MAX);
        break;
    case 'd':
        o->distribution = parse_kind(optarg);
        break;
    case 's':
        o->seed = parse_seed(optarg);
        break;
    case 'a':
        o->structure = parse_structure(optarg);
        break;
    case 't':
        o->threads = parse_count("-t", optarg, 1, MAX_THREADS);
        break;
    case 'r':
        o->trials = parse_count("-r", optarg, 1, 1000000);
        break;
    case 'o':
        if (!*optarg)
            fail("-o: expected the name of a file, or -");
        o->output = optarg;
        break;
    default:
        take_long_option(o, option, argv);
    }
}

static void check_options(const struct options *o)
{
    if (o->file && o->n)
        fail("points come from a file or from -n, not from both");
    if (!o->file && !o->n)
        fail("which points? Name a FILE, or say -n N for random ones; "
             "see range --help");
    if (o->file && o->dimensions)
        fail("--dimensions is for random points; a file has as many "
             "as it has columns");
    if (!o->wish)
        fail("what is asked? Say --box, --within R or --nearest K; see "
             "range --help");
    if (o->queries && o->random)
        fail("queries come from a file or from --random, not from "
             "both");
    if (o->file && o->queries && strcmp(o->file, "-") == 0 &&
        strcmp(o->queries, "-") == 0)
        fail("points and queries cannot both be standard input");
    if (o->wish != BOXES && !o->structure->neighbors)
        fail("%s finds no neighbors; see range --list",
             o->structure->name);
    if (o->timing && o->output && strcmp(o->output, "-") == 0)
        fail("--timing and -o - both want standard output");
}

static const struct option names[] = {
    {"dimensions", required_argument, NULL, DIMENSIONS},
    {"box", no_argument, NULL, BOX},
    {"within", required_argument, NULL, WITHIN_R},
    {"nearest", required_argument, NULL, NEAREST_OF},
    {"queries", required_argument, NULL, QUERIES},
    {"random", required_argument, NULL, RANDOM},
    {"share", required_argument, NULL, SHARE},
    {"counts", no_argument, NULL, COUNTS},
    {"timing", no_argument, NULL, TIMING},
    {"check", no_argument, NULL, CHECK},
    {"list", no_argument, NULL, LIST},
    {"help", no_argument, NULL, HELP},
    {0},
};

struct options parse_range_options(int argc, char **argv)
{
    struct options o = {.distribution = &distributions[0],
                        .seed = 1,
                        .share = 0.1,
                        .structure = find_structure("kd-tree"),
                        .trials = 1};
    opterr = 0; // the sentences are ours
    for (int option;
         (option = getopt_long(argc, argv, ":n:d:s:a:t:r:o:", names,
                               NULL)) != -1;)
        take_option(&o, option, argv);
    if (argc - optind > 1)
        fail("one FILE at a time, please: \"%s\" and \"%s\" are two",
             argv[optind], argv[optind + 1]);
    o.file = argv[optind];
    if (!o.list && !o.help)
        check_options(&o);
    return o;
}
