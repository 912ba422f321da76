// The tests of broad.c and steps.c, for the table of contact.c.
#pragma once
#include "harness.h"

void all_broad_phases(void);
void moving_scenes(void);
void work_grows_linearly(void);
void a_step_grows_linearly(void);
void nothing_is_allocated(void);
void tables_are_searched(void);

#define BROAD_TESTS                                             \
    TEST(all_broad_phases), TEST(moving_scenes),                \
        TEST(work_grows_linearly), TEST(a_step_grows_linearly), \
        TEST(nothing_is_allocated), TEST(tables_are_searched)

void boxes_hold_all_events(void);
void boxes_have_their_margin(void);
void apart_means_no_event(void);
void threads_find_the_same(void);
void a_pile_stays_apart(void);
void a_ball_comes_to_rest(void);
void a_bullet_is_stopped(void);
void a_resting_cloth_has_no_contact(void);
void a_folding_cloth_has_contacts(void);
void bodies_turn(void);
void near_bodies_stay(void);

#define STEP_TESTS                                               \
    TEST(boxes_hold_all_events), TEST(boxes_have_their_margin),  \
        TEST(apart_means_no_event), TEST(threads_find_the_same), \
        TEST(a_pile_stays_apart), TEST(a_ball_comes_to_rest),    \
        TEST(a_bullet_is_stopped),                               \
        TEST(a_resting_cloth_has_no_contact),                    \
        TEST(a_folding_cloth_has_contacts), TEST(bodies_turn),   \
        TEST(near_bodies_stay)

void a_blow_wakes_a_body(void);
void what_falls_does_not_sleep(void);
void a_body_wakes_when_its_support_goes(void);
void a_heap_rests_for_long(void);
void none_sleeps_without_patience(void);

#define SLEEP_TESTS                                             \
    TEST(a_blow_wakes_a_body), TEST(what_falls_does_not_sleep), \
        TEST(a_body_wakes_when_its_support_goes),               \
        TEST(a_heap_rests_for_long),                            \
        TEST(none_sleeps_without_patience)
