// Price the primitives in turn.
// See workload.h.
#include "ch06-pack-scan/experiments/workload.h"

// Know what a primitive touches.
const char *const work_names[WORKS] = {"elementwise",
                                       "gather_in_order",
                                       "gather_at_random",
                                       "gather32_in_order",
                                       "gather32_at_random",
                                       "scatter_in_order",
                                       "scatter_at_random",
                                       "scan",
                                       "pack"};

// How many arrays of doubles, of 32-bit numbers and of flags, and
// whether the first numbers are shuffled.
static const struct {
    int doubles, numbers, flags, shuffled;
} arrays[WORKS] = {{3, 0, 0, 0}, {2, 1, 0, 0}, {2, 1, 0, 1},
                   {0, 3, 0, 0}, {0, 3, 0, 1}, {2, 1, 0, 0},
                   {2, 1, 0, 1}, {0, 2, 0, 0}, {0, 2, 1, 0}};

// Make a workload.
static void shuffle(uint32_t *index, uint32_t n, struct random *random)
{
    for (uint32_t i = n; i > 1; i--) {
        uint32_t j = random_bits(random) % i, last = index[i - 1];
        index[i - 1] = index[j];
        index[j] = last;
    }
}

struct workload workload_make(enum work work, size_t bytes)
{
    int doubles = arrays[work].doubles, numbers = arrays[work].numbers;
    int flags = arrays[work].flags;
    uint32_t n = bytes / (8 * doubles + 4 * numbers + flags);
    struct workload w = {.work = work, .n = n};
    struct random random = {n};
    for (int k = 0; k < doubles; k++) {
        w.doubles[k] = allocate(n, sizeof(double));
        for (uint32_t i = 0; i < n; i++)
            w.doubles[k][i] = i;
    }
    for (int k = 0; k < numbers; k++) {
        w.numbers[k] = allocate(n, sizeof(uint32_t));
        for (uint32_t i = 0; i < n; i++)
            w.numbers[k][i] = i;
    }
    if (flags)
        w.keep = allocate(n, sizeof(uint8_t));
    for (uint32_t i = 0; flags && i < n; i++)
        w.keep[i] = random_bits(&random) & 1;
    if (arrays[work].shuffled)
        shuffle(w.numbers[0], n, &random);
    return w;
}

void workload_free(struct workload *workload)
{
    for (int k = 0; k < 3; k++) {
        free(workload->doubles[k]);
        free(workload->numbers[k]);
    }
    free(workload->keep);
    *workload = (struct workload){0};
}

// Run a primitive.
static void run_once(const struct primitives *p,
                     const struct workload *w)
{
    double *const *d = w->doubles;
    uint32_t *const *u = w->numbers;
    switch (w->work) {
    case GATHER_IN_ORDER:
    case GATHER_AT_RANDOM:
        p->gather(d[0], d[1], u[0], w->n);
        break;
    case GATHER32_IN_ORDER:
    case GATHER32_AT_RANDOM:
        p->gather32(u[1], u[2], u[0], w->n);
        break;
    case SCATTER_IN_ORDER:
    case SCATTER_AT_RANDOM:
        p->scatter(d[0], d[1], u[0], w->n);
        break;
    case SCAN:
        p->scan(u[0], u[1], w->n, 0);
        break;
    case PACK:
        p->pack(u[0], u[1], w->keep, w->n);
        break;
    default:
        p->add(d[0], d[1], d[2], w->n);
    }
}

// Time a primitive by element.
// A trial handles a million elements or so, however short the arrays.
static uint32_t rounds(const struct workload *w)
{
    enum { ELEMENTS = 1 << 20 };
    return w->n < ELEMENTS ? ELEMENTS / w->n : 1;
}

static void run_rounds(void *context)
{
    const struct priced *priced = context;
    for (uint32_t r = rounds(priced->workload); r > 0; r--)
        run_once(priced->primitives, priced->workload);
}

void price_in_turn(int trials, struct priced *priced, int count)
{
    struct trial *turns = allocate(count, sizeof *turns);
    for (int k = 0; k < count; k++)
        turns[k] =
            (struct trial){.work = run_rounds, .context = &priced[k]};
    time_in_turn(trials, turns, count);
    for (int k = 0; k < count; k++) {
        const struct workload *w = priced[k].workload;
        double elements = (double)w->n * rounds(w);
        struct summary s = turns[k].summary;
        priced[k].ns = (struct summary){
            s.min / elements, s.q1 / elements, s.median / elements,
            s.q3 / elements, s.max / elements};
    }
    free(turns);
}

// Price every primitive on one level.
void price_tables(int trials, size_t bytes,
                  const struct primitives *const *tables, int count,
                  struct summary ns[][WORKS])
{
    struct priced *priced = allocate(count, sizeof *priced);
    for (int work = 0; work < WORKS; work++) {
        struct workload workload = workload_make(work, bytes);
        for (int k = 0; k < count; k++)
            priced[k] = (struct priced){.primitives = tables[k],
                                        .workload = &workload};
        price_in_turn(trials, priced, count);
        for (int k = 0; k < count; k++)
            ns[k][work] = priced[k].ns;
        workload_free(&workload);
    }
    free(priced);
}
