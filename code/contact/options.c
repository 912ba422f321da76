// One option after the other, then what they say together.
#include "contact/options.h"
#include "common/fail.h"
#include "near/command.h"
#include "near/threads.h"
#include "near/values.h"

enum { SCENE = 256, STEPS, DT, TOLERANCE, PICTURES };

static const struct built_in *parse_scene(const char *text)
{
    const struct built_in *found = find_built_in(text);
    if (!found)
        fail("--scene: there is no scene \"%s\"; see contact --list",
             text);
    return found;
}

static const struct broad_phase *parse_broad(const char *text)
{
    const struct broad_phase *found = find_broad_phase(text);
    if (!found)
        fail("-a: there is no broad phase \"%s\"; see contact --list",
             text);
    return found;
}

static void take_option(void *options, int option)
{
    struct options *o = options;
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
        o->pictures =
            parse_name("--pictures", "the name of a folder", optarg);
        break;
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
        o->output =
            parse_name("-o", "the name of a file, or -", optarg);
        break;
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
    if (o->built_in && (o->size < o->built_in->min_size ||
                        o->size > o->built_in->max_size))
        fail("-n: %s can have a size from %u to %u", o->built_in->name,
             o->built_in->min_size, o->built_in->max_size);
}

struct options parse_contact_options(int argc, char **argv)
{
    struct options o = {
        .seed = 1, .steps = 100, .broad = find_broad_phase("clusters")};
    const struct option names[] = {
        {"scene", required_argument, NULL, SCENE},
        {"steps", required_argument, NULL, STEPS},
        {"dt", required_argument, NULL, DT},
        {"tolerance", required_argument, NULL, TOLERANCE},
        {"pictures", required_argument, NULL, PICTURES},
        {"events", no_argument, &o.events, true},
        {"passive", no_argument, &o.passive, true},
        {"check", no_argument, &o.check, true},
        {"list", no_argument, &o.list, true},
        {"help", no_argument, &o.help, true},
        {0},
    };
    const struct command contact = {"contact", ":n:s:a:t:o:", names,
                                    take_option};
    o.file = take_options(&contact, argc, argv, &o);
    if (!o.list && !o.help)
        check_options(&o);
    return o;
}
