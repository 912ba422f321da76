// See results.h. The driver of experiments prints the cells, so that
// the table looks like all others.
#include "peers/results.h"
#include "common/experiment.h"

const char result_columns[] =
    "name program kind n order leaf trials build:3 query:3 total:3 "
    "build_all:3 query_all:3 total_all:3 expected differ";

static void print_times(const struct times *times, bool measured,
                        uint32_t n)
{
    static const struct summary none = {NAN, NAN, NAN, NAN, NAN};
    row_times(measured ? &times->build : &none, n);
    row_times(measured ? &times->query : &none, n);
    row_times(measured ? &times->total : &none, n);
}

void print_result(const struct entry *entry,
                  const struct result *result)
{
    const bool run = result->trials > 0;
    const uint32_t n = entry->n;
    row_begin("%s_%s_%u_%s\t%s\t%s\t%u\t%s\t%d\t%d", entry->program,
              entry->kind, n, entry->order, entry->program, entry->kind,
              n, entry->order, entry->leaf_size, result->trials);
    print_times(&result->one, run, n);
    print_times(&result->all, run && result->threaded, n);
    row_cells("\t%.4g\t%u", run ? NAN : result->expected / n,
              run ? result->differ : 0);
    row_end();
}
