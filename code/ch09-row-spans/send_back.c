//> Send the answers back
// See send_back.h.
#include "ch09-row-spans/send_back.h"
#include "common/fail.h"
#include <stdlib.h>

struct findings findings_for(const struct answers *answers, uint32_t n)
{
    struct findings findings = {NULL, NULL};
    if (answers->nearest)
        findings.nearest = allocate(n, sizeof *findings.nearest);
    if (answers->furthest)
        findings.furthest = allocate(n, sizeof *findings.furthest);
    return findings;
}

void findings_free(struct findings *findings)
{
    free(findings->nearest);
    free(findings->furthest);
    *findings = (struct findings){NULL, NULL};
}

//> Pack a turn's answers
static void pack(const uint32_t *came, uint32_t begin, uint32_t end,
                 const uint32_t *who, const double *d2,
                 struct finding *parcel)
{
    for (uint32_t s = begin; s < end; s++)
        parcel[came[s]] =
            (struct finding){d2[s - begin], who[s - begin]};
}
//<

void findings_pack(const struct carried *carried, uint32_t begin,
                   uint32_t end, const struct answers *found,
                   const struct findings *findings)
{
    if (findings->nearest)
        pack(carried->came, begin, end, found->nearest, found->nearest2,
             findings->nearest);
    if (findings->furthest)
        pack(carried->came, begin, end, found->furthest,
             found->furthest2, findings->furthest);
}

//> Hand the answers to those who asked
static void hand_out(const struct finding *parcel, const uint32_t *sent,
                     uint32_t n, int threads, uint32_t *who, double *d2)
{
#pragma omp parallel for num_threads(threads)
    for (uint32_t i = 0; i < n; i++) {
        const struct finding finding = parcel[sent[i]];
        who[i] = finding.who;
        d2[i] = finding.d2;
    }
}
//<

void findings_send_back(const struct carried *carried,
                        const struct findings *findings, int threads,
                        struct answers *answers)
{
    const uint32_t n = carried->sorted.points.n;
    if (findings->nearest)
        hand_out(findings->nearest, carried->sent, n, threads,
                 answers->nearest, answers->nearest2);
    if (findings->furthest)
        hand_out(findings->furthest, carried->sent, n, threads,
                 answers->furthest, answers->furthest2);
}
//<
