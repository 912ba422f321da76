//> Remember contacts
// What touched once will touch again: gravity pulls anew in each step.
// Old contacts and new events are both sorted by their features, so
// they are merged, in time in proportion to both.
#include "ch13-contact/contact_cache.h"
#include "ch13-contact/enlarge.h"
#include "ch13-contact/vectors.h"
#include "common/fail.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

//> Find the two features of a contact
// Of a node and a face, or of two edges, the first has split nodes.
struct feature feature_of(const struct event *event, int which)
{
    const int split = event->kind == NODE_FACE ? 1 : 2;
    return which == 0
               ? (struct feature){event->node, event->weight, split}
               : (struct feature){event->node + split,
                                  event->weight + split, 4 - split};
}

void bodies_of_contact(const struct contact *contact,
                       const struct scene *scene, uint32_t two[2])
{
    for (int k = 0; k < 2; k++)
        two[k] =
            scene->body_of_node[feature_of(&contact->event, k).node[0]];
}

void feature_position(const struct scene *scene, struct feature feature,
                      double time, double position[3])
{
    for (int k = 0; k < 3; k++) {
        position[k] = 0;
        for (int f = 0; f < feature.count; f++) {
            const double a = scene->mesh.x[k][feature.node[f]];
            const double b = scene->predicted[k][feature.node[f]];
            position[k] += feature.weight[f] * (a + time * (b - a));
        }
    }
}
//<

//> Find the normal of a contact
// From one node to another at that time.
static void edge_at(const struct scene *scene, const struct event *e,
                    int from, int to, double edge[3])
{
    for (int k = 0; k < 3; k++) {
        const double *x = scene->mesh.x[k], *end = scene->predicted[k];
        const uint32_t i = e->node[from], j = e->node[to];
        edge[k] =
            x[j] - x[i] + e->time * (end[j] - x[j] - (end[i] - x[i]));
    }
}

// Upright on the face, or on the two edges, at the time of the event,
// and to the side on which the first feature was at the beginning.
// Parallel edges span no plane: then straight away from each other.
static void find_normal(const struct scene *scene,
                        const struct event *e, double normal[3])
{
    double a[3], b[3], first[3], second[3], apart[3];
    const bool face = e->kind == NODE_FACE;
    edge_at(scene, e, face ? 1 : 0, face ? 2 : 1, a);
    edge_at(scene, e, face ? 1 : 2, 3, b);
    cross(a, b, normal);
    feature_position(scene, feature_of(e, 0), 0, first);
    feature_position(scene, feature_of(e, 1), 0, second);
    for (int k = 0; k < 3; k++)
        apart[k] = first[k] - second[k];
    if (dot(normal, normal) <= 1e-12 * dot(a, a) * dot(b, b))
        memcpy(normal, apart, sizeof apart);
    const double length = sqrt(dot(normal, normal));
    const double sign = dot(normal, apart) < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++)
        normal[k] = length > 0 ? sign * normal[k] / length : k == 2;
}
//<

//> Make room for contacts
static void reserve(struct contact_cache *cache, uint64_t wanted)
{
    if (wanted <= cache->room)
        return;
    if (wanted > UINT32_MAX / 2)
        fail("more contacts than can be numbered");
    const uint32_t room = (uint32_t)(wanted + wanted / 2 + 64);
    const size_t size = sizeof *cache->contact;
    cache->contact = enlarge(cache->contact, cache->count, room, size);
    cache->other = enlarge(cache->other, 0, room, size);
    cache->room = room;
}
//<

//> Let contacts age
void contacts_age(struct contact_cache *cache,
                  const struct scene *scene)
{
    for (uint32_t c = 0; c < cache->count; c++) {
        uint32_t two[2];
        bodies_of_contact(&cache->contact[c], scene, two);
        cache->contact[c].age += scene->body[two[0]].motion != ASLEEP &&
                                 scene->body[two[1]].motion != ASLEEP;
    }
}
//<

//> Merge old contacts with new events
void contacts_merge(struct contact_cache *cache,
                    const struct scene *scene,
                    const struct events *events)
{
    const struct event_list *fresh = &events->all;
    reserve(cache, cache->count + fresh->count);
    uint32_t old = 0, kept = 0;
    uint64_t e = 0;
    while (old < cache->count || e < fresh->count) {
        const struct contact *contact = &cache->contact[old];
        const int order =
            old == cache->count ? 1
            : e == fresh->count
                ? -1
                : compare_features(&contact->event, &fresh->event[e]);
        struct contact *to = &cache->other[kept];
        if (order < 0) {
            *to = *contact;
            kept += to->age <= cache->max_age;
        } else {
            to->event = fresh->event[e++];
            to->age = 0;
            find_normal(scene, &to->event, to->normal);
            kept++;
        }
        old += order <= 0;
    }
    struct contact *swap = cache->contact;
    cache->contact = cache->other;
    cache->other = swap;
    cache->count = kept;
}
//<

void contacts_free(struct contact_cache *cache)
{
    free(cache->contact);
    free(cache->other);
    *cache = (struct contact_cache){0};
}
//<
