// The tests of the narrow phase, narrow.c and narrow_events.c, for the
// table of contact.c.
#pragma once
#include "common/random.h"
#include "harness.h"
#include <stdlib.h>

static inline uint32_t pair_count(uint32_t usual)
{
    const char *wanted = getenv("CONTACT_PAIRS");
    return at_most("MOST_CASES",
                   wanted ? (uint32_t)atoi(wanted) : usual);
}

// From -max to max.
static inline int64_t pick(struct random *random, int64_t max)
{
    return (int64_t)(random_bits(random) % (2 * max + 1)) - max;
}

void ranges_are_checked(void);
void sides_are_exact(void);
void nearly_flat_sides_are_exact(void);
void triangles_at_rest(void);
void planned_contacts_are_found(void);
void sampled_contacts_are_found(void);
void what_stays_apart_has_no_event(void);
void a_bullet_hits_a_sheet(void);
void what_does_not_move(void);
void shared_nodes_are_no_contact(void);
void scales_make_no_difference(void);

#define NARROW_TESTS                                                \
    TEST(ranges_are_checked), TEST(sides_are_exact),                \
        TEST(nearly_flat_sides_are_exact), TEST(triangles_at_rest), \
        TEST(planned_contacts_are_found),                           \
        TEST(sampled_contacts_are_found),                           \
        TEST(what_stays_apart_has_no_event),                        \
        TEST(a_bullet_hits_a_sheet), TEST(what_does_not_move),      \
        TEST(shared_nodes_are_no_contact),                          \
        TEST(scales_make_no_difference)
