// One option after the other, then what they say together.
#include "range/options.h"
#include "common/fail.h"
#include "near/command.h"
#include "near/threads.h"
#include "near/values.h"
#include <string.h>

enum {
    DIMENSIONS = 256,
    BOX,
    WITHIN_R,
    NEAREST_OF,
    QUERIES,
    RANDOM,
    SHARE
};

static void ask(struct options *options, enum range_question question)
{
    if (options->question && options->question != question)
        fail("one of --box, --within and --nearest at a time");
    options->question = question;
}

static const struct structure *parse_structure(const char *text)
{
    const struct structure *found = find_structure(text);
    if (!found)
        fail("-a: there is no structure \"%s\"; see range --list",
             text);
    return found;
}

static void take_name(struct options *o, int option)
{
    switch (option) {
    case DIMENSIONS:
        o->dimensions =
            parse_count("--dimensions", optarg, 1, MAX_DIMENSIONS);
        break;
    case BOX:
        ask(o, BOXES);
        break;
    case WITHIN_R:
        ask(o, WITHIN);
        o->distance = parse_distance("--within", optarg);
        break;
    case NEAREST_OF:
        ask(o, NEAREST_K);
        o->k = parse_count("--nearest", optarg, 1, UINT32_MAX);
        break;
    case QUERIES:
        o->queries = optarg;
        break;
    case RANDOM:
        o->random = parse_count("--random", optarg, 1, UINT32_MAX);
        break;
    case SHARE:
        o->share = parse_number("--share", optarg, 0, 1);
        break;
    }
}

static void take_option(void *options, int option)
{
    struct options *o = options;
    switch (option) {
    case 'n':
        o->n = parse_count("-n", optarg, 1, UINT32_MAX);
        break;
    case 'd':
        o->distribution = parse_distribution("range", optarg);
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
        o->output =
            parse_name("-o", "the name of a file, or -", optarg);
        break;
    default:
        take_name(o, option);
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
    if (!o->question)
        fail("what is asked? Say --box, --within R or --nearest K; see "
             "range --help");
    if (o->queries && o->random)
        fail("queries come from a file or from --random, not from "
             "both");
    if (o->file && o->queries && strcmp(o->file, "-") == 0 &&
        strcmp(o->queries, "-") == 0)
        fail("points and queries cannot both be standard input");
    if (o->question != BOXES && !o->structure->neighbors)
        fail("%s finds no neighbors; see range --list",
             o->structure->name);
    if (o->timing && o->output && strcmp(o->output, "-") == 0)
        fail("--timing and -o - both want standard output");
}

struct options parse_range_options(int argc, char **argv)
{
    struct options o = {.distribution = &distributions[0],
                        .seed = 1,
                        .share = 0.1,
                        .structure = find_structure("kd-tree"),
                        .trials = 1};
    const struct option names[] = {
        {"dimensions", required_argument, NULL, DIMENSIONS},
        {"box", no_argument, NULL, BOX},
        {"within", required_argument, NULL, WITHIN_R},
        {"nearest", required_argument, NULL, NEAREST_OF},
        {"queries", required_argument, NULL, QUERIES},
        {"random", required_argument, NULL, RANDOM},
        {"share", required_argument, NULL, SHARE},
        {"counts", no_argument, &o.counts, true},
        {"timing", no_argument, &o.timing, true},
        {"check", no_argument, &o.check, true},
        {"list", no_argument, &o.list, true},
        {"help", no_argument, &o.help, true},
        {0},
    };
    const struct command range = {"range", ":n:d:s:a:t:r:o:", names,
                                  take_option};
    o.file = take_options(&range, argc, argv, &o);
    if (!o.list && !o.help)
        check_options(&o);
    return o;
}
