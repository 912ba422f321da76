// The tests of broad.c, readers.c and steps.c, for the table of
// contact.c.
#pragma once
#include "harness.h"

void all_broad_phases(void);
void moving_scenes(void);
void work_grows_linearly(void);
void nothing_is_allocated(void);
void tables_are_searched(void);

#define BROAD_TESTS                                            \
    TEST(all_broad_phases), TEST(moving_scenes),               \
        TEST(work_grows_linearly), TEST(nothing_is_allocated), \
        TEST(tables_are_searched)

void shapes_are_closed(void);
void meshes_are_read(void);
void bad_meshes_are_refused(void);
void hostile_bytes_end_in_a_sentence(void);
void equal_nodes_are_merged(void);

#define READER_TESTS                                \
    TEST(shapes_are_closed), TEST(meshes_are_read), \
        TEST(bad_meshes_are_refused),               \
        TEST(hostile_bytes_end_in_a_sentence),      \
        TEST(equal_nodes_are_merged)

void boxes_hold_all_events(void);
void apart_means_no_event(void);
void threads_find_the_same(void);
void a_pile_stays_apart(void);
void a_ball_comes_to_rest(void);
void a_bullet_is_stopped(void);
void a_resting_cloth_has_no_contact(void);
void a_folding_cloth_has_contacts(void);
void bodies_turn(void);

#define STEP_TESTS                                             \
    TEST(boxes_hold_all_events), TEST(apart_means_no_event),   \
        TEST(threads_find_the_same), TEST(a_pile_stays_apart), \
        TEST(a_ball_comes_to_rest), TEST(a_bullet_is_stopped), \
        TEST(a_resting_cloth_has_no_contact),                  \
        TEST(a_folding_cloth_has_contacts), TEST(bodies_turn)
