// One option after the other, then what they say together: what
// contradicts itself is refused before any work is done.
#include "near/options.h"
#include "common/fail.h"
#include "common/isa.h"
#include "near/command.h"
#include "near/threads.h"
#include "near/values.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { COLUMNS = 256, BOX, WITHIN };

static void take_letter(struct options *o, int option)
{
    switch (option) {
    case 'a':
        o->algorithm = parse_algorithm(optarg);
        break;
    case 'g':
        o->geometry = parse_geometry(optarg);
        break;
    case 'k':
        o->k = parse_count("-k", optarg, 1, UINT32_MAX);
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
    }
}

static void take_option(void *options, int option)
{
    struct options *o = options;
    o->random |= option == 'n' || option == 'd' || option == 's';
    switch (option) {
    case COLUMNS:
        o->columns = parse_columns(optarg);
        break;
    case BOX:
        parse_box(o->box, optarg);
        o->has_box = true;
        break;
    case WITHIN:
        o->distance = parse_distance("--within", optarg);
        o->within = true;
        break;
    case 'n':
        o->n = parse_count("-n", optarg, 2, UINT32_MAX);
        break;
    case 'd':
        o->distribution = parse_distribution("near", optarg);
        break;
    case 's':
        o->seed = parse_seed(optarg);
        break;
    default:
        take_letter(o, option);
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

static void check_options(const struct options *o)
{
    if (o->file && o->random)
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
    struct options o = {.distribution = &distributions[0],
                        .seed = 1,
                        .geometry = STANDARD,
                        .trials = 1};
    const struct option names[] = {
        {"columns", required_argument, NULL, COLUMNS},
        {"box", required_argument, NULL, BOX},
        {"within", required_argument, NULL, WITHIN},
        {"counts", no_argument, &o.counts, true},
        {"timing", no_argument, &o.timing, true},
        {"check", no_argument, &o.check, true},
        {"list", no_argument, &o.list, true},
        {"help", no_argument, &o.help, true},
        {0},
    };
    const struct command near = {"near", ":n:d:s:a:g:k:t:r:o:", names,
                                 take_option};
    o.file = take_options(&near, argc, argv, &o);
    if (!o.list && !o.help)
        check_options(&o);
    return o;
}
