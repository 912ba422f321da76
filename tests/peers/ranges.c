// See ranges.h. SciPy is asked where there is one; in its place, a
// command that fails, and one that ends well and says nothing.
#include "ranges.h"
#include "common/experiment.h"
#include "harness.h"
#include "peers/range_scene.h"
#include "peers/range_scipy.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { N = 300 };

// With the answers to all that is compared.
static struct range_scene known_scene(const char *kind, int d)
{
    struct range_scene scene = range_scene_of(kind, N, d);
    for (uint32_t i = 0; i < N; i++)
        for (uint32_t j = 0; j < N; j++) {
            double sum2 = 0;
            for (int k = 0; k < d; k++) {
                const double *x = scene.points.x[k];
                sum2 += (x[i] - x[j]) * (x[i] - x[j]);
            }
            scene.within += sum2 <= scene.distance * scene.distance;
        }
    scene.in_boxes = 1234;
    return scene;
}

static void scene_free(struct range_scene *scene)
{
    point_set_free(&scene->points);
    forget();
}

// ---- the comparison ------------------------------------------------
struct sham {
    struct range_run run;
    struct range_scene *scene;
};

static void compare_sham(void *context)
{
    const struct sham *sham = context;
    compare_answers("sham", &sham->run, sham->scene);
}

void wrong_ranges_are_refused(void)
{
    struct range_scene scene = known_scene("uniform", 2);
    const size_t bytes = sizeof(double) * N * NEIGHBORS_WANTED;
    memcpy(scene.nearest2, scene.right2, bytes);
    struct sham right = {{{1, 1, 1, 1}, scene.within, scene.in_boxes},
                         &scene};
    compare_sham(&right);
    struct sham wrong = right;
    wrong.run.within++;
    CHECK_FAILS("points within", compare_sham, &wrong, "one more");
    wrong.run.ns[ALL_WITHIN] = 0;
    compare_sham(&wrong); // not asked
    wrong = right;
    wrong.run.in_boxes--;
    CHECK_FAILS("sham: 1233 points in boxes, and not 1234",
                compare_sham, &wrong, "one less");
    scene.nearest2[7 * NEIGHBORS_WANTED + 3] *= 1 + 1e-11;
    CHECK_FAILS("sham: neighbor 3 of point 7 is at", compare_sham,
                &right, "too far");
    scene.nearest2[7 * NEIGHBORS_WANTED + 3] = NAN;
    CHECK_FAILS("sham: neighbor 3 of point 7 is at nan", compare_sham,
                &right, "no number");
    scene_free(&scene);
}

// ---- SciPy ---------------------------------------------------------
static bool choose_python(void)
{
    static const char *const names[] = {"python3", "/usr/bin/python3"};
    for (int i = 0; i < COUNT_OF(names); i++) {
        setenv("PYTHON", names[i], 1);
        if (scipy_is_there())
            return true;
    }
    return false;
}

void scipy_answers_rightly(void)
{
    static const char *const kinds[] = {"uniform", "kuzmin"};
    for (int i = 0; i < 2 * COUNT_OF(kinds) && choose_python(); i++) {
        struct range_scene scene = known_scene(kinds[i / 2], 2 + i % 2);
        const struct range_run run = run_scipy(&scene);
        CHECK(run.ns[BUILD] > 0 && run.ns[NEAREST_ONES] > 0 &&
                  run.ns[ALL_WITHIN] > 0,
              "%s: times", kinds[i / 2]);
        CHECK_DOUBLE(0, run.ns[IN_BOXES], "boxes are not asked");
        CHECK_INT(scene.within, run.within, "%s: within", kinds[i / 2]);
        compare_answers("SciPy", &run, &scene);
        scene_free(&scene);
    }
    unsetenv("PYTHON");
}

static void ask_scipy(void *scene)
{
    run_scipy(scene);
}

void python_may_be_missing(void)
{
    setenv("PYTHON", "false", 1);
    CHECK(!scipy_is_there(), "a Python that fails");
    struct range_scene scene = known_scene("uniform", 2);
    setenv("PYTHON", "true", 1);
    CHECK(scipy_is_there(), "one that ends well");
    CHECK_FAILS("SciPy has not answered about 300 points", ask_scipy,
                &scene, "and says nothing");
    scene_free(&scene);
    unsetenv("PYTHON");
}
