// Fills arrays for a primitive and runs it on them. A run goes over its
// arrays so often that it handles a million elements or so, however
// short they are.
#include "ch06-pack-scan/experiments/workload.h"

enum { MOST_TABLES = 3 }; // priced in turn

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

static void shuffle(uint32_t *index, uint32_t n, struct random *random)
{
    for (uint32_t i = n; i > 1; i--) {
        uint32_t j = random_bits(random) % i, last = index[i - 1];
        index[i - 1] = index[j];
        index[j] = last;
    }
}

struct workload {
    enum work work;
    uint32_t n;           // elements
    double *doubles[3];   // as many of each as the primitive needs
    uint32_t *numbers[3]; // an index is the first
    uint8_t *keep;
};

static struct workload workload_make(enum work work, size_t bytes)
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

static void workload_free(struct workload *workload)
{
    for (int k = 0; k < 3; k++) {
        free(workload->doubles[k]);
        free(workload->numbers[k]);
    }
    free(workload->keep);
}

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

// A trial handles a million elements or so, however short the arrays.
static uint32_t rounds(const struct workload *w)
{
    enum { ELEMENTS = 1 << 20 };
    return w->n < ELEMENTS ? ELEMENTS / w->n : 1;
}

struct pricing {
    const struct primitives *primitives;
    const struct workload *workload;
};

static void run_rounds(void *context)
{
    const struct pricing *pricing = context;
    for (uint32_t r = rounds(pricing->workload); r > 0; r--)
        run_once(pricing->primitives, pricing->workload);
}

void price_work(enum work work, size_t bytes, int trials,
                const struct primitives *const *tables, int count,
                struct summary *ns)
{
    struct workload w = workload_make(work, bytes);
    struct pricing pricing[MOST_TABLES];
    struct trial turns[MOST_TABLES];
    for (int k = 0; k < count; k++) {
        pricing[k] = (struct pricing){tables[k], &w};
        turns[k] = (struct trial){run_rounds, &pricing[k]};
    }
    time_in_turn(trials, turns, count);
    double elements = (double)w.n * rounds(&w);
    for (int k = 0; k < count; k++) {
        struct summary s = turns[k].summary;
        ns[k] = (struct summary){s.min / elements, s.q1 / elements,
                                 s.median / elements, s.q3 / elements,
                                 s.max / elements};
    }
    workload_free(&w);
}

void price_tables(int trials, size_t bytes,
                  const struct primitives *const *tables, int count,
                  struct summary ns[][WORKS])
{
    for (int work = 0; work < WORKS; work++) {
        struct summary of_work[MOST_TABLES];
        price_work(work, bytes, trials, tables, count, of_work);
        for (int k = 0; k < count; k++)
            ns[k][work] = of_work[k];
    }
}
