// The work of a trial is one call.
#include "ch02-all-pairs/experiments/rows.h"
#include "common/experiment.h"

void run_rows(void *context)
{
    struct run *run = context;
    run->rows(run->question, run->answers, run->begin, run->end);
}
