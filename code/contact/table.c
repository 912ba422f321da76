// Rows of numbers, a tab between two: counts and times of each phase,
// or events with their nodes.
#include "contact/table.h"
#include "common/numbers.h"
#include "near/write.h"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static void write_text(const char *text)
{
    write_bytes(text, strlen(text));
}

void write_step_head(void)
{
    write_text(
        "step\ttested\tcandidates\tfalse_positives\tevents\ttouches"
        "\tstopped\trounds\tasleep\tpredict_ns\tcapture_ns\tbroad_ns"
        "\tnarrow_ns\thandle_ns\n");
}

void write_step(uint32_t step, const struct step_report *r)
{
    char line[320];
    const double false_positives = (double)(r->candidates - r->hits);
    int used = snprintf(
        line, sizeof line,
        "%" PRIu32 "\t%" PRIu64 "\t%" PRIu64 "\t%.6g\t%" PRIu64
        "\t%" PRIu32 "\t%" PRIu32 "\t%" PRIu32 "\t%" PRIu32,
        step, r->tested, r->candidates,
        r->candidates > 0 ? false_positives / (double)r->candidates : 0,
        r->events, r->contacts, r->stopped, r->rounds, r->asleep);
    for (int phase = 0; phase < PHASES; phase++)
        used += snprintf(line + used, sizeof line - used, "\t%" PRId64,
                         r->ns[phase]);
    write_text(line);
    write_text("\n");
}

void write_event_head(void)
{
    write_text(
        "step\tkind\tnode1\tnode2\tnode3\tnode4\ttime\tx\ty\tz\n");
}

static void write_event(uint32_t step, const struct event *event)
{
    char line[120 + 4 * (LONGEST_NUMBER + 1)];
    char *end = line + snprintf(line, 120,
                                "%" PRIu32 "\t%s\t%" PRIu32 "\t%" PRIu32
                                "\t%" PRIu32 "\t%" PRIu32,
                                step,
                                event->kind == NODE_FACE ? "node-face"
                                                         : "edge-edge",
                                event->node[0], event->node[1],
                                event->node[2], event->node[3]);
    *end++ = '\t';
    end = number_to_text(end, event->time);
    for (int k = 0; k < 3; k++) {
        *end++ = '\t';
        end = number_to_text(end, event->point[k]);
    }
    *end++ = '\n';
    write_bytes(line, end - line);
}

void write_events(uint32_t step, const struct events *events)
{
    for (uint64_t e = 0; e < events->all.count; e++)
        write_event(step, &events->all.event[e]);
}
