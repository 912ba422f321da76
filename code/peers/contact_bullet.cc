// Bullet's two broad phases: a dynamic tree of boxes, and sweep and
// prune along three axes. Its numbers are floats, and boxes are rounded
// outwards.
#include "peers/broad_phase_peer.h"
#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/BroadphaseCollision/btDispatcher.h>
#include <cmath>
#include <vector>

namespace
{
btVector3 rounded(const double *x, float to)
{
    float r[3];
    for (int k = 0; k < 3; k++) {
        r[k] = static_cast<float>(x[k]);
        if (to < 0 ? r[k] > x[k] : r[k] < x[k])
            r[k] = std::nextafter(r[k], to);
    }
    return btVector3(r[0], r[1], r[2]);
}

struct kept {
    btBroadphaseInterface *broadphase;
    std::vector<btBroadphaseProxy *> proxy;
    std::vector<char> object; // a place in memory for each box
    std::vector<std::pair<btBroadphaseProxy *, btBroadphaseProxy *>>
        pairs;
};

void *fill(btBroadphaseInterface *broadphase, const double *box,
           uint32_t n)
{
    kept *k = new kept{broadphase, {}, std::vector<char>(n), {}};
    for (uint32_t i = 0; i < n; i++, box += 6)
        k->proxy.push_back(broadphase->createProxy(
            rounded(box, -INFINITY), rounded(box + 3, INFINITY), 0,
            &k->object[i], 1, 1, nullptr));
    return k;
}

void *begin_dbvt(const double *box, uint32_t n)
{
    return fill(new btDbvtBroadphase(), box, n);
}

// Boxes come one by one, and each of their ends moves past half of all
// others, along three axes.
void *begin_sap(const double *box, uint32_t n)
{
    btVector3 low(INFINITY, INFINITY, INFINITY), high(-low);
    for (uint32_t i = 0; i < n; i++) {
        low.setMin(rounded(box + 6 * (size_t)i, -INFINITY));
        high.setMax(rounded(box + 6 * (size_t)i + 3, INFINITY));
    }
    const btVector3 room = 0.1f * (high - low);
    return fill(new bt32BitAxisSweep3(low - room, high + room, n + 2),
                box, n);
}

uint64_t find(void *made, const double *box)
{
    kept *k = static_cast<kept *>(made);
    for (btBroadphaseProxy *proxy : k->proxy) {
        k->broadphase->setAabb(proxy, rounded(box, -INFINITY),
                               rounded(box + 3, INFINITY), nullptr);
        box += 6;
    }
    k->broadphase->calculateOverlappingPairs(nullptr);
    btBroadphasePairArray &found =
        k->broadphase->getOverlappingPairCache()
            ->getOverlappingPairArray();
    k->pairs.clear();
    for (int p = 0; p < found.size(); p++)
        k->pairs.emplace_back(found[p].m_pProxy0, found[p].m_pProxy1);
    return k->pairs.size();
}

void end(void *made)
{
    kept *k = static_cast<kept *>(made);
    for (btBroadphaseProxy *proxy : k->proxy)
        k->broadphase->destroyProxy(proxy, nullptr);
    delete k->broadphase;
    delete k;
}
} // namespace

const struct broad_phase_peer contact_dbvt = {
    "bullet-dbvt", begin_dbvt, find, end, 1, 0};
const struct broad_phase_peer contact_sap = {
    "bullet-sap", begin_sap, find, end, 1, 1};
