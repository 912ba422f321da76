// Where does the time of a whole job go? Points are read from a file,
// both answers are found and written to another, as near does it: by
// one thread and by all, as text and as arrays of NumPy's. A trial
// makes anew what it needs, as in a job that is done once. job-plain.c
// has numbers read and written by the C library.
#include "common/experiment.h"
#include "common/numbers.h"
#include "common/read_points.h"
#include "near/table.h"
#include "near/write.h"
#include <errno.h>
#include <inttypes.h>
#include <unistd.h>

#ifndef WAY
#define WAY "text"
#define KINDS 2 // text, array
#endif

// What the parts of a job hand on.
struct job {
    const char *name;
    char input[64], output[64];
    struct question question;
    struct answers answers;
};

static void read_part(void *context)
{
    struct job *job = context;
    points_free(&job->question.points);
    job->question.points = read_points(
        job->input, (struct columns){0, 0}, job->question.threads);
}

static void answer_part(void *context)
{
    struct job *job = context;
    answers_free(&job->answers);
    job->answers = answers_allocate(job->question.points.n);
    find_algorithm("near-and-far")->run(&job->question, &job->answers);
}

static void write_part(void *context)
{
    struct job *job = context;
    write_open(job->output);
    write_table(table_kind(job->output), &job->question, &job->answers);
    write_close();
}

static void print_line(FILE *file, double x, double y)
{
    char line[2 * LONGEST_NUMBER + 2], *end = number_to_text(line, x);
    *end++ = ' ';
    end = number_to_text(end, y);
    *end++ = '\n';
    fwrite(line, 1, end - line, file);
}

// One column after the other: Fortran's order.
static void print_array(FILE *file, struct points points)
{
    char head[100];
    snprintf(head, sizeof head,
             "{'descr': '<f8', 'fortran_order': True, 'shape': "
             "(%" PRIu32 ", 2), }",
             points.n);
    fwrite("\x93NUMPY\1\0\x76", 1, 10, file); // 118 bytes follow
    fprintf(file, "%-117s\n", head);
    fwrite(points.x, sizeof(double), points.n, file);
    fwrite(points.y, sizeof(double), points.n, file);
}

static struct job make_job(const char *folder, const char *name,
                           struct points points, int threads)
{
    struct job job = {.name = name,
                      .question = uniform_question(STANDARD, 2, 1)};
    const char *ending = strstr(name, "array") ? "npy" : "tsv";
    job.question.threads = threads;
    snprintf(job.input, sizeof job.input, "%s/in.%s", folder, ending);
    snprintf(job.output, sizeof job.output, "%s/out.%s", folder,
             ending);
    FILE *file = fopen(job.input, "w");
    if (!file)
        fail("cannot write %s: %s", job.input, strerror(errno));
    if (strcmp(ending, "npy") == 0)
        print_array(file, points);
    else
        for (uint32_t i = 0; i < points.n; i++)
            print_line(file, points.x[i], points.y[i]);
    if (fclose(file) != 0)
        fail("cannot write %s: %s", job.input, strerror(errno));
    return job;
}

static void list_parts(struct job *job, struct trial parts[static 3])
{
    parts[0] = (struct trial){read_part, job};
    parts[1] = (struct trial){answer_part, job};
    parts[2] = (struct trial){write_part, job};
}

static void end_job(struct job *job)
{
    unlink(job->input);
    unlink(job->output);
    points_free(&job->question.points);
    answers_free(&job->answers);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 50000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    static const char *const names[] = {WAY "_one", WAY "_all",
                                        "array_one", "array_all"};
    char folder[] = "/tmp/near-job-XXXXXX";
    if (!mkdtemp(folder))
        fail("cannot make a folder in /tmp: %s", strerror(errno));
    struct points points = uniform_question(STANDARD, n, 1).points;
    struct job jobs[2 * KINDS];
    struct trial parts[6 * KINDS];
    for (int k = 0; k < 2 * KINDS; k++) {
        jobs[k] = make_job(folder, names[k], points,
                           k % 2 ? omp_get_max_threads() : 1);
        list_parts(&jobs[k], &parts[3 * k]);
    }
    time_in_turn(trials, parts, 6 * KINDS);
    print_header(&e, "name threads read_ns:3 answer_ns:3 write_ns:3");
    for (int k = 0; k < 2 * KINDS; k++)
        row_of_times(&parts[3 * k], 3, n, "%s\t%d", jobs[k].name,
                     jobs[k].question.threads);
    for (int k = 0; k < 2 * KINDS; k++)
        end_job(&jobs[k]);
    points_free(&points);
    rmdir(folder);
    return 0;
}
