// One option after the other, then what they say together.
#include "contact/options.h"
#include "common/fail.h"
#include "near/threads.h"
#include "near/values.h"
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

enum {
    SCENE = 256,
    STEPS,
    DT,
    TOLERANCE,
    EVENTS,
    PICTURES,
    PASSIVE,
    CHECK,
    LIST,
    HELP
};

static double parse_number(const char *option, const char *text,
                           double least, double most)
{
    char *end;
    const double number = strtod(text, &end);
    if (end == text || *end || strpbrk(text, "xX") ||
        !(number >= least && number <= most))
        fail("%s: expected a number from %g to %g, found \"%s\"",
             option, least, most, text);
    return number;
}

static const struct built_in *parse_scene(const char *text)
{
    const struct built_in *found = find_built_in(text);
    if (!found)
        fail("--scene: there is no scene \"%s\"; see contact --list",
             text);
    return found;
}

static const struct broad *parse_broad(const char *text)
{
    const struct broad *found = find_broad(text);
    if (!found)
        fail("-a: there is no broad phase \"%s\"; see contact --list",
             text);
    return found;
}

static const char *parse_name(const char *option, const char *text)
{
    if (!*text)
        fail("%s: expected a name, found nothing", option);
    return text;
}

static _Noreturn void refuse(int option, char **argv)
{
    if (option == ':')
        fail("%s needs a value; see contact --help", argv[optind - 1]);
    if (optopt != 0 && optopt < SCENE)
        fail("what is -%c? See contact --help", optopt);
    fail("what is %s? See contact --help", argv[optind - 1]);
}

static void take_flag(struct options *o, int option, char **argv)
{
    switch (option) {
    case EVENTS:
        o->events = true;
        break;
    case PASSIVE:
        o->passive = true;
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
    default:
        refuse(option, argv);
    }
}

static void take_long_option(struct options *o, int option, char **argv)
{
    switch (option) {
    case SCENE:
        o->built_in = parse_scene(optarg);
        break;
    case STEPS:
        o->steps = parse_count("--steps", optarg, 1, UINT32_MAX);
        break;
    case DT:
        o->dt = parse_number("--dt", optarg, 1e-9, 1e9);
        break;
    case TOLERANCE:
        o->tolerance = parse_number("--tolerance", optarg, 1e-60, 1e60);
        break;
    case PICTURES:
        o->pictures = parse_name("--pictures", optarg);
        break;
    default:
        take_flag(o, option, argv);
    }
}

static void take_option(struct options *o, int option, char **argv)
{
    switch (option) {
    case 'n':
        o->size = parse_count("-n", optarg, 1, UINT32_MAX);
        break;
    case 's':
        o->seed = parse_seed(optarg);
        break;
    case 'a':
        o->broad = parse_broad(optarg);
        break;
    case 't':
        o->threads = parse_count("-t", optarg, 1, MAX_THREADS);
        break;
    case 'o':
        o->output = parse_name("-o", optarg);
        break;
    default:
        take_long_option(o, option, argv);
    }
}

static void check_options(struct options *o)
{
    if (o->file && o->built_in)
        fail("the scene comes from a file or from --scene, not from "
             "both");
    if (!o->file && !o->built_in)
        fail("which scene? Name a FILE, or say --scene NAME; see "
             "contact --help");
    if (o->file && o->size)
        fail(
            "-n is for a scene of the list; a file has its own bodies");
    if (o->events && !o->output)
        fail("--events is what -o writes; say -o FILE as well");
    if (o->built_in && !o->size)
        o->size = o->built_in->usual;
    if (o->built_in &&
        (o->size < o->built_in->least || o->size > o->built_in->most))
        fail("-n: %s can have a size from %u to %u", o->built_in->name,
             o->built_in->least, o->built_in->most);
}

static const struct option names[] = {
    {"scene", required_argument, NULL, SCENE},
    {"steps", required_argument, NULL, STEPS},
    {"dt", required_argument, NULL, DT},
    {"tolerance", required_argument, NULL, TOLERANCE},
    {"events", no_argument, NULL, EVENTS},
    {"pictures", required_argument, NULL, PICTURES},
    {"passive", no_argument, NULL, PASSIVE},
    {"check", no_argument, NULL, CHECK},
    {"list", no_argument, NULL, LIST},
    {"help", no_argument, NULL, HELP},
    {0},
};

struct options parse_contact_options(int argc, char **argv)
{
    struct options o = {
        .seed = 1, .steps = 100, .broad = find_broad("clusters")};
    opterr = 0; // the sentences are ours
    for (int option; (option = getopt_long(argc, argv, ":n:s:a:t:o:",
                                           names, NULL)) != -1;)
        take_option(&o, option, argv);
    if (argc - optind > 1)
        fail("one FILE at a time, please: \"%s\" and \"%s\" are two",
             argv[optind], argv[optind + 1]);
    o.file = argv[optind];
    if (!o.list && !o.help)
        check_options(&o);
    return o;
}
