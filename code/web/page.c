// A page's points, and the answers of any algorithm of the table. The
// page writes and reads the arrays where they are, in memory.
#include "web/page.h"
#include "algorithms.h"
#include "common/generate.h"
#include "common/read_points.h"
#include "web/text.h"
#include <string.h>

struct question page_question = {.threads = 1};
struct answers page_answers;
struct counts page_counts;

static void keep(struct points points)
{
    page_forget_cells();
    points_free(&page_question.points);
    answers_free(&page_answers);
    page_question.points = points;
    page_answers = answers_allocate(points.n);
}

// Room for n points, whose coordinates the page writes.
void EXPORT(set_points)(uint32_t n)
{
    keep(points_allocate(n));
}

// n points of a kind, as near -d has them; false if there is no such.
bool EXPORT(generate_points)(const char *kind, uint32_t n,
                             uint32_t seed)
{
    const struct distribution *d = find_distribution(kind);
    if (d)
        keep(generate(d, n, seed));
    return d;
}

// The points in the text that the page has written; text that holds
// none ends the program with a sentence.
uint32_t EXPORT(read_text)(const char *name)
{
    keep(read_points(name, (struct columns){0, 0}, 1));
    return page_question.points.n;
}

// Geometry 1 or 2, as enum geometry; the box begins at 0.
void EXPORT(set_geometry)(int geometry, double width, double height)
{
    page_question.space = (struct space){geometry, width, height};
}

// Has the row of this name answer; false if there is no such row.
bool EXPORT(ask)(const char *name)
{
    const struct algorithm *row = find_algorithm(name);
    if (row) {
        page_counts = (struct counts){0};
        page_question.counts = &page_counts;
        row->run(&page_question, &page_answers);
    }
    return row;
}

// ---- where things are in memory -------------------------------------
double *EXPORT(x)(void)
{
    return page_question.points.x;
}
double *EXPORT(y)(void)
{
    return page_question.points.y;
}
uint32_t *EXPORT(nearest)(void)
{
    return page_answers.nearest;
}
uint32_t *EXPORT(furthest)(void)
{
    return page_answers.furthest;
}
double *EXPORT(nearest2)(void)
{
    return page_answers.nearest2;
}
double *EXPORT(furthest2)(void)
{
    return page_answers.furthest2;
}
double EXPORT(distances)(void)
{
    return page_counts.distances;
}

// Room for a string or a file that the page writes.
char *EXPORT(room)(uint32_t bytes)
{
    return text_room(bytes);
}
