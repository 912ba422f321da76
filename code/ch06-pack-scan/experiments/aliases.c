// A step of 256 lanes, with its arrays in pages drawn at random.
// Nanoseconds for a lane's step, in the best placement of many, in the
// middle one, one of the worst twentieth and the worst; and in how many
// placements it takes more than twice as long as in the best. Once all
// five arrays are at the same place of their pages, once each is 512
// bytes further.
//     aliases [PLACEMENTS [PAGES]]
#include "ch06-pack-scan/escape.h"
#include "common/experiment.h"

enum { LANES = 256, STEPS = 256, PAGE = 4096, TRIES = 9 };

struct pages {
    char *memory;
    uint32_t count;
    struct random random;
};

// The array number k of a placement.
static double *place(struct pages *pages, int k, size_t shift)
{
    size_t page = random_bits(&pages->random) % pages->count;
    return (double *)(pages->memory + page * PAGE + k * shift);
}

// The least of several times, for a lane's step: what disturbs a try
// makes it longer, never shorter.
static double time_placement(struct lanes *lanes, struct points c,
                             double *steps)
{
    const struct primitives *p = primitives(isa_chosen());
    double best = INFINITY;
    for (int k = 0; k < TRIES; k++) {
        int64_t start = clock_ns();
        uint64_t done = escape(p, c, STEPS, 0, lanes, steps);
        double ns = (double)(clock_ns() - start) / done;
        best = ns < best ? ns : best;
    }
    return best;
}

static void print_row(const char *name, double *ns, int count)
{
    int slow = 0;
    summarize(ns, count); // sorts them
    for (int k = 0; k < count; k++)
        slow += ns[k] > 2 * ns[0];
    row("%s\t%d\t%.4g\t%.4g\t%.4g\t%.4g\t%.4g", name, count, ns[0],
        ns[count / 2], ns[count - 1 - count / 20], ns[count - 1],
        (double)slow / count);
}

// Pages to choose from; two more, for arrays that go over the end of
// theirs.
static struct pages pages_take(uint32_t count)
{
    const size_t bytes = ((size_t)count + 2) * PAGE;
    struct pages pages = {aligned_alloc(PAGE, bytes), count, {1}};
    if (!pages.memory)
        fail("no memory for %zu bytes", bytes);
    memset(pages.memory, 0, bytes);
    return pages;
}

// Points that never escape.
static struct points stay(void)
{
    struct points c = picture(LANES, 1);
    for (uint32_t i = 0; i < c.n; i++)
        c.x[i] = -0.1, c.y[i] = 0.1;
    return c;
}

static void time_placements(struct pages *pages, size_t shift,
                            int count, double *ns)
{
    const struct points c = stay();
    struct lanes lanes = lanes_allocate(LANES);
    double *steps = take(LANES, sizeof *steps);
    double **arrays[] = {&lanes.cx, &lanes.cy, &lanes.x, &lanes.y,
                         &lanes.age};
    for (int k = 0; k < count; k++) {
        for (int a = 0; a < COUNT_OF(arrays); a++)
            *arrays[a] = place(pages, a, shift);
        ns[k] = time_placement(&lanes, c, steps);
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    int count = parameter(&e, "PLACEMENTS", 200, 20, 100000);
    struct pages pages =
        pages_take(parameter(&e, "PAGES", 1 << 13, 16, 1 << 20));
    double *ns = take(count, sizeof *ns);
    print_header(&e,
                 "name placements best middle twentieth worst slow");
    time_placements(&pages, 0, count, ns);
    print_row("same", ns, count);
    time_placements(&pages, PAGE / 8, count, ns);
    print_row("apart", ns, count);
}
