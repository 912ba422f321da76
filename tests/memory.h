// Whether an algorithm keeps its memory: repeated with a workspace, it
// touches no new page, and the workspace is as small as was promised.
#pragma once
#include "algorithms.h"
#include "common/generate.h"
#include "common/workspace.h"
#include "harness.h"
#include <sys/resource.h>

// A sanitizer touches pages for its own records.
#if defined __SANITIZE_ADDRESS__ || defined __SANITIZE_THREAD__
enum { MOST_FAULTS = 1000 };
#else
enum { MOST_FAULTS = 20 };
#endif

static inline long page_faults(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

// Less than so many bytes a point, besides points and answers.
static inline void check_memory_kept(const char *name, int threads,
                                     size_t most_bytes)
{
    const struct algorithm *row = find_algorithm(name);
    const uint32_t n = 300000;
    for (int g = STANDARD; g <= WRAPAROUND; g++) {
        struct workspace workspace = {0};
        struct question question = {
            generate(find_distribution("uniform"), n, 1),
            {g, 1, 1},
            threads,
            .workspace = &workspace};
        struct answers answers = answers_for(n, row->answers);
        long faults[3] = {0};
        for (int trial = 0; trial < 3; trial++) {
            long before = page_faults();
            row->run(&question, &answers);
            faults[trial] = page_faults() - before;
        }
        CHECK(faults[1] + faults[2] < MOST_FAULTS,
              "%s: %ld pages touched again, %d threads, geometry %d",
              name, faults[1] + faults[2], threads, g);
        size_t bytes = 0;
        for (int k = 0; k < WORKSPACE_BLOCKS; k++)
            bytes += workspace.block[k].size;
        CHECK(bytes < most_bytes * n, "%s: %zu bytes kept", name,
              bytes);
        workspace_free(&workspace);
        answers_free(&answers);
        points_free(&question.points);
    }
}
