// All nearest neighbors of points that crowd, by the programs of
// chapter 11 and by four libraries, one thread and all, the points as
// they come: of every kind of points, 1000, 10000, ... LARGEST of them,
// and of the points of some files. A program that would take too long,
// judging by fewer points, is not run.
//     crowds [LARGEST [TRIALS [SECONDS [FILE...]]]]
#include "common/read_points.h"
#include "peers/contenders.h"

enum { FEWEST = 1000 };

static const char *const ours[] = {"by-sample", "adaptive",
                                   "row-spans"};
static void compete_for(struct points points,
                        const struct workload *workload,
                        const struct rules *rules,
                        struct contenders *contenders)
{
    struct instance instance = instance_of(points);
    compete_on(workload, rules, &instance, contenders);
    instance_free(&instance);
}

// A file is known by the last part of its name, up to a dot.
static void compete_for_file(const char *file, int number,
                             const struct rules *rules,
                             struct contenders *contenders)
{
    const char *slash = strrchr(file, '/');
    char name[40];
    snprintf(name, sizeof name, "%s", slash ? slash + 1 : file);
    name[strcspn(name, ".")] = 0;
    const struct workload workload = {name, "file", number};
    compete_for(
        read_points(file, (struct columns){0, 0}, rules->threads),
        &workload, rules, contenders);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t largest = parameter(&e, "LARGEST", 10000, FEWEST, MANY);
    struct rules rules = {.limit = MAX_NS_A_POINT,
                          .threads = omp_get_num_procs()};
    rules.trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    rules.patience = 1e9 * parameter(&e, "SECONDS", 2, 1, MANY);
    const int files = e.next;
    e.next = argc;
    static struct contenders contenders;
    contenders = contenders_of(ours, COUNT_OF(ours));
    print_head(&e);
    for (uint64_t n = FEWEST; n <= largest; n *= 10)
        for (int kind = 0; kind < distribution_count; kind++) {
            const struct distribution *d = &distributions[kind];
            const struct workload workload = {d->name, "unordered",
                                              kind};
            compete_for(generate(d, n, 1), &workload, &rules,
                        &contenders);
        }
    for (int file = files; file < argc; file++)
        compete_for_file(argv[file], distribution_count + file - files,
                         &rules, &contenders);
}
