// The grader: runs the tests of an exercise against a student's file.
//
//   GRADER [-s SEED] [-l SECONDS] [-n WHY -v VERDICT] [-p PICTURE]
//          [-u WORDS] LIBRARY SOURCE SCORES [TEST...]
//
// -n fails every test for this reason and runs none: no seed would
// change that, and the table has none. PICTURE becomes what wrong.gp
// draws, if a test has failed that can be drawn. -u ends with the first
// test that fails with these words: enough, to know a mistake again.
//
// SCORES becomes a table, tab-separated, one row a test, with all that
// a report needs. What the student's code prints is passed on, but is
// never taken for a result: the table is out of its reach.
#include "common/clock.h"
#include "common/fail.h"
#include "common/generate.h"
#include "confine.h"
#include "fence.h"
#include "grader.h"
#include <ctype.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <math.h>
#include <omp.h>
#include <poll.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#if defined __linux__ && __has_include(<execinfo.h>)
#define TRACES true
#include <execinfo.h>
#include <link.h>
#endif

#if defined __has_feature
#if __has_feature(address_sanitizer)
#define SANITIZED true
#endif
#elif defined __SANITIZE_ADDRESS__
#define SANITIZED true
#endif
#ifdef SANITIZED
#include <sanitizer/asan_interface.h>
#else
#define SANITIZED false
#define ASAN_POISON_MEMORY_REGION(from, bytes) ((void)0)
#endif

enum {
    OUTPUT_MAX = 1 << 20, // bytes that a call may print
    MEMORY_MAX = 4,       // GB that it may ask for
    CALLS_MAX = 20,       // limits that all calls together may take
    STOPS_MAX = 2,        // calls that do not end until we give up
    SHOWN_MAX = 12,       // lines of its output that are passed on
    NAP = 10,             // ms
};

struct grader grader;

// In the student's process only.
static struct {
    void *library;
    char *base; // where it is loaded
    size_t size;
    struct sigaction refused_before;
} student;

// What the sanitizers are asked for; both know these names.
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
    return "detect_leaks=0:exitcode=99:symbolize=0";
}

const char *__ubsan_default_options(void);
const char *__ubsan_default_options(void)
{
    return "exitcode=99";
}

// ---- text ----------------------------------------------------------

// What is counted in sentences, one of it and many.
static const char *const units[][2] = {
    {"1 points", "1 point"},
    {"1 numbers", "1 number"},
    {"1 values", "1 value"},
    {"1 different values", "1 different value"},
    {"1 cells", "1 cell"},
    {"1 boxes", "1 box"},
    {"1 dimensions", "1 dimension"},
    {"1 leaves", "1 leaf"},
    {"1 threads", "1 thread"},
    {"1 tasks", "1 task"},
    {"1 steps", "1 step"},
    {"1 rounds", "1 round"},
    {"1 rows", "1 row"},
    {"1 columns", "1 column"},
    {"1 bins", "1 bin"},
    {"1 keys", "1 key"},
    {"1 bits", "1 bit"},
    {"1 records", "1 record"},
    {"1 flags", "1 flag"},
    {"1 elements", "1 element"},
    {"1 places", "1 place"},
    {"1 lines", "1 line"},
    {"1 queries", "1 query"},
    {"1 candidates", "1 candidate"},
    {"1 triangles", "1 triangle"},
    {"1 questions", "1 question"},
    {"1 pairs", "1 pair"},
    {"1 corners", "1 corner"},
};

// "1 points" becomes "1 point", but "1.1 points" and "11 points" stay.
static void count_to_one(char *text)
{
    for (size_t u = 0; u < sizeof units / sizeof *units; u++) {
        const size_t many = strlen(units[u][0]);
        const size_t one = strlen(units[u][1]);
        for (char *at = text; (at = strstr(at, units[u][0])); at++) {
            const bool whole =
                at == text || strchr(" ,:;(", at[-1]) != NULL;
            if (!whole || isalpha((unsigned char)at[many]))
                continue;
            memcpy(at, units[u][1], one);
            memmove(at + one, at + many, strlen(at + many) + 1);
        }
    }
}

const char *kit_text(const char *format, ...)
{
    size_t room = sizeof grader.text - grader.text_length;
    char *text = grader.text + grader.text_length;
    va_list arguments;
    va_start(arguments, format);
    size_t length = vsnprintf(text, room, format, arguments);
    va_end(arguments);
    if (length >= room)
        fail("the messages of a test are too long");
    count_to_one(text);
    grader.text_length += length + 1;
    return text;
}

const char *kit_point(struct points points, uint32_t i)
{
    if (i >= points.n)
        return kit_text("%u, which is no point's index", i);
    return kit_text("point %u at (%.9g, %.9g)", i, points.x[i],
                    points.y[i]);
}

void kit_given(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char *given = student.library ? grader.trace->given : grader.given;
    vsnprintf(given, sizeof grader.given, format, arguments);
    va_end(arguments);
    count_to_one(given);
}

void kit_if_endless(const char *cause)
{
    grader.endless = cause;
}

// ---- arrays --------------------------------------------------------

// Where no other array gives away that there is one: a wish, which the
// system grants if nothing lies there, and its machine has the place.
// Drawn once for the first array of every case, once for the second,
// and so on: no call knows what the one before it knew, and all places
// that were ever used cost time when a process is copied.
static void *anywhere(int number, size_t page)
{
    static void *places[ARRAYS_MAX];
    const uint64_t lowest = (uint64_t)1 << 45, range = lowest;
    uint64_t draw;
    if (!places[number] && getentropy(&draw, sizeof draw) == 0)
        places[number] =
            (void *)(uintptr_t)((lowest + draw % range) / page * page);
    return places[number];
}

static void *add_array(const char *name, size_t count, size_t size,
                       bool input)
{
    if (grader.array_count == ARRAYS_MAX)
        fail("a test has too many arrays: call kit_next_case");
    size_t page = sysconf(_SC_PAGESIZE);
    size_t bytes = (count * size + page - 1) / page * page + page;
    char *pages =
        mmap(anywhere(grader.array_count, page), bytes + page,
             PROT_READ | PROT_WRITE,
             (input ? MAP_PRIVATE : MAP_SHARED) | MAP_ANONYMOUS, -1, 0);
    if (pages == MAP_FAILED ||
        mprotect(pages + bytes, page, PROT_NONE) != 0)
        fail("no memory for the array %s", name);
    memset(pages, POISON, bytes);
    struct array *array = &grader.arrays[grader.array_count++];
    *array = (struct array){.name = name,
                            .pages = pages,
                            .start = pages + bytes - count * size,
                            .end = pages + bytes,
                            .size = size,
                            .input = input};
    return array->start;
}

void *kit_input(const char *name, size_t count, size_t size)
{
    return add_array(name, count, size, true);
}

void *kit_output(const char *name, size_t count, size_t size)
{
    return add_array(name, count, size, false);
}

void kit_next_case(void)
{
    grader.text_length = 0;
    size_t page = sysconf(_SC_PAGESIZE);
    while (grader.array_count > 0) {
        struct array *array = &grader.arrays[--grader.array_count];
        munmap(array->pages, array->end - array->pages + page);
    }
}

struct points kit_points(const char *distribution, uint32_t n,
                         uint64_t seed)
{
    const struct distribution *found = find_distribution(distribution);
    if (!found)
        fail("no distribution is called %s", distribution);
    struct points points = {
        .n = n,
        .x = kit_input("points.x", n, sizeof(double)),
        .y = kit_input("points.y", n, sizeof(double)),
    };
    if (n > 0)
        found->fill(points, seed);
    kit_given("%u points, %s", n, distribution);
    return points;
}

// ---- the student's process -----------------------------------------

// Notes the address and lets what was there before take over: a
// sanitizer's report, or the end.
static void note_address(int signal, siginfo_t *info, void *context)
{
    (void)context;
    grader.trace->address = info->si_addr;
    sigaction(signal, &student.refused_before, NULL);
}

#ifdef TRACES
// Goes up through the callers to the first one in the student's file.
static void tell_place(int signal)
{
    enum { FRAMES_MAX = 32 };
    void *frames[FRAMES_MAX];
    struct trace *trace = grader.trace;
    int count = backtrace(frames, FRAMES_MAX);
    for (int f = 0; f < count && !trace->place; f++) {
        const uintptr_t base = (uintptr_t)student.base;
        const uintptr_t at = (uintptr_t)frames[f];
        Dl_info ours, callee;
        if (at <= base || at - base >= student.size)
            continue;
        trace->place = at - 1 - base; // we would return to at
        if (f > 0 && dladdr((void *)&kit_tests, &ours) &&
            dladdr(frames[f - 1], &callee) && callee.dli_sname &&
            callee.dli_fbase == ours.dli_fbase)
            snprintf(trace->called, sizeof trace->called, "%s",
                     callee.dli_sname);
    }
    trace->asked = signal != 0;
}

static void be_ready_to_tell(void)
{
    struct link_map *map;
    off_t size = lseek(grader.file, 0, SEEK_END);
    if (dlinfo(student.library, RTLD_DI_LINKMAP, &map) == 0) {
        student.base = (char *)map->l_addr;
        student.size = size > 0 ? size : 0;
    }
}

static void listen_for_questions(void)
{
    sigaction(SIGUSR1,
              &(struct sigaction){.sa_handler = tell_place,
                                  .sa_flags = SA_ONSTACK | SA_RESTART},
              NULL);
}

// In the judge, so that no process need load what it takes; nor could
// it, later.
static void learn_to_tell(void)
{
    tell_place(0);
}
#else
static void be_ready_to_tell(void)
{
}

static void listen_for_questions(void)
{
}

static void learn_to_tell(void)
{
}
#endif

// In the judge. It need not answer, and need not be believed.
static void ask_for_place(pid_t process)
{
    enum { NAPS_MAX = 100 };
    if (kill(process, SIGUSR1) != 0)
        return;
    for (int naps = 0; naps < NAPS_MAX && !grader.trace->asked; naps++)
        poll(NULL, 0, 1);
}

static void catch_refused_accesses(void)
{
    static char stack[1 << 16]; // the ordinary one may be used up
    sigaltstack(&(stack_t){.ss_sp = stack, .ss_size = sizeof stack},
                NULL);
    struct sigaction action = {.sa_sigaction = note_address,
                               .sa_flags = SA_SIGINFO | SA_ONSTACK};
    sigaction(SIGBUS, &action, &student.refused_before);
    sigaction(SIGSEGV, &action, &student.refused_before);
}

static void protect_arrays(void)
{
    for (int a = 0; a < grader.array_count; a++) {
        struct array *array = &grader.arrays[a];
        ASAN_POISON_MEMORY_REGION(array->pages,
                                  array->start - array->pages);
        if (array->input)
            mprotect(array->pages, array->end - array->pages,
                     PROT_READ);
    }
}

static _Noreturn void give_up(const char *problem, const char *name)
{
    snprintf(grader.trace->problem, sizeof grader.trace->problem,
             "%s %s", problem, name);
    _exit(1);
}

const char *loaded_name(void)
{
    static char name[64];
#ifdef __linux__
    snprintf(name, sizeof name, "/proc/self/fd/%d", grader.file);
#else
    snprintf(name, sizeof name, "/dev/fd/%d", grader.file);
#endif
    return name;
}

static size_t memory_limit(void)
{
    double there =
        (double)sysconf(_SC_PHYS_PAGES) * sysconf(_SC_PAGESIZE);
    return fmin((double)MEMORY_MAX * (1 << 30), there / 2);
}

// Where sanitizers want to look at their own process, each needs a
// fence of its own.
static int own_fence(void)
{
    return has_rules() ? build_fence(grader.file, NULL, SANITIZED) : -1;
}

static void become_student(int pipe)
{
    int fence = SANITIZED ? own_fence() : grader.fence;
    int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(grader.printed, STDOUT_FILENO);
    dup2(grader.printed, STDERR_FILENO);
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ); // a crash loses nothing
    omp_get_num_procs(); // has OpenMP look around while it may
    protect_arrays();
    catch_refused_accesses();
    listen_for_questions();
    confine((struct limits){.seconds = grader.limit,
                            .printed = OUTPUT_MAX,
                            .memory = memory_limit(),
                            .keep = {grader.file, pipe, fence}},
            fence);
    student.library = dlopen(loaded_name(), RTLD_NOW | RTLD_LOCAL);
    if (!student.library) {
        const char *why = dlerror(), *key = "undefined symbol: ";
        const char *symbol = strstr(why, key);
        if (symbol)
            give_up("it uses but does not define",
                    symbol + strlen(key));
        give_up("it cannot be loaded:", why);
    }
    be_ready_to_tell();
    close(grader.file);
    grader.trace->loaded = true;
    if (write(pipe, "", 1) != 1)
        _exit(1);
    if (!SANITIZED) // which reads files for its report
        confine_to_computing();
}

void (*kit_function(const char *name))(void)
{
    void (*function)(void);
    void *symbol = dlsym(student.library, name);
    if (!symbol)
        give_up("it does not define the function", name);
    memcpy(&function, &symbol, sizeof function);
    return function;
}

_Noreturn void kit_leave(void)
{
    fflush(stdout);
    grader.trace->finished = true;
    _exit(0);
}

// ---- the end of a call ---------------------------------------------

_Noreturn static void end_test(const char *status)
{
    grader.status = status;
    longjmp(grader.end, 1);
}

static void put_pair(FILE *file, struct points points,
                     const uint32_t *pair)
{
    fprintf(file, "\n\n");
    for (int k = 0; k < 2; k++)
        if (pair[k] < points.n)
            fprintf(file, "%.17g\t%.17g\n", points.x[pair[k]],
                    points.y[pair[k]]);
}

// Where there are no cells, a line of no length.
static void put_borders(FILE *file, const struct kit_cells *cells,
                        struct points points)
{
    const double *x = cells->column_border, *y = cells->row_border;
    fprintf(file, "\n\n");
    if (!x || !y) {
        fprintf(file, "%.17g\t%.17g\n", points.x[0], points.y[0]);
        return;
    }
    for (uint32_t k = 0; k <= cells->columns; k++)
        fprintf(file, "%.17g\t%.17g\n%.17g\t%.17g\n\n", x[k], y[0],
                x[k], y[cells->rows]);
    for (uint32_t k = 0; k <= cells->rows; k++)
        fprintf(file, "%.17g\t%.17g\n%.17g\t%.17g\n\n", x[0], y[k],
                x[cells->columns], y[k]);
}

// The first that can be drawn is drawn.
static void draw(const struct kit_picture *picture,
                 const struct kit_cells *cells)
{
    struct points points = picture->points;
    FILE *file = grader.picture && points.n > 0
                     ? fopen(grader.picture, "w")
                     : NULL;
    if (!file)
        return;
    for (uint32_t i = 0; i < points.n; i++)
        fprintf(file, "%.17g\t%.17g\n", points.x[i], points.y[i]);
    put_pair(file, points, picture->found);
    put_pair(file, points, picture->right);
    put_borders(file, cells, points);
    fclose(file);
    grader.picture = NULL;
}

_Noreturn void kit_wrong(struct kit_fault fault)
{
    if (student.library)
        kit_leave();
    grader.fault = fault;
    draw(&fault.picture, &fault.cells);
    end_test("wrong");
}

_Noreturn void kit_not_graded(const char *why)
{
    grader.fault = (struct kit_fault){.found = why};
    end_test("not graded");
}

bool kit_is_sanitized(void)
{
    return SANITIZED;
}

double kit_seconds(bool by_clock)
{
    return by_clock ? grader.seconds : grader.processor_seconds;
}

_Noreturn void broken(const char *status, const char *found,
                      const char *cause)
{
    grader.fault = (struct kit_fault){.found = found, .cause = cause};
    if (grader.trace->given[0])
        snprintf(grader.given, sizeof grader.given, "%.*s",
                 (int)sizeof grader.given - 1, grader.trace->given);
    end_test(status);
}

static char *read_printed(void)
{
    static char text[OUTPUT_MAX + 1];
    ssize_t got = pread(grader.printed, text, OUTPUT_MAX, 0);
    text[got < 0 ? 0 : got] = '\0';
    return text;
}

static void put_line(const char *text, int length)
{
    fputs("    | ", stdout);
    for (int k = 0; k < length; k++)
        putchar((unsigned char)text[k] < ' ' && text[k] != '\t'
                    ? '?'
                    : text[k]);
    putchar('\n');
}

static void pass_on(const char *text, const char *end)
{
    for (int lines = 0; text < end && *text; lines++) {
        if (lines == SHOWN_MAX) {
            puts("    | ... and more");
            break;
        }
        int length = strcspn(text, "\n");
        put_line(text, length);
        text += length + (text[length] == '\n');
    }
    fflush(stdout);
}

static double in_seconds(struct timeval time)
{
    return (double)time.tv_sec + (double)time.tv_usec * 1e-6;
}

// How long the next call may take.
static double time_left(void)
{
    return fmin(grader.limit, fmax(grader.budget, 1));
}

// Waits for the process, though not for ever: false if it did not end.
// It holds the other end of a pipe, into which it writes when it begins
// to work; the system closes it when the process is gone. So we know
// how long it worked, whatever it says.
static bool wait_for(pid_t process, int pipe, int *status)
{
    int64_t begin = clock_ns(), start = begin, now;
    double limit = time_left();
    struct rusage used = {0};
    bool ended, open = true;
    const int end = end_of(process);
    do {
        // A child of its own may hold the pipe, too: do not sleep long.
        struct pollfd said[] = {{open ? pipe : -1, POLLIN, 0},
                                {end, POLLIN, 0}};
        poll(said, 2, open || end >= 0 ? NAP : 1);
        ended = wait4(process, status, WNOHANG, &used) == process;
        now = clock_ns();
        if (said[0].revents) {
            char byte;
            open = read(pipe, &byte, 1) == 1;
            if (open && start == begin)
                start = now;
        }
    } while (!ended && (now - begin) * 1e-9 <= limit);
    if (end >= 0)
        close(end);
    grader.seconds = (now - start) * 1e-9;
    grader.processor_seconds =
        in_seconds(used.ru_utime) + in_seconds(used.ru_stime);
    grader.budget -= (now - begin) * 1e-9;
    if (!ended)
        ask_for_place(process);
    end_children(process);
    return ended;
}

_Noreturn static void stopped(bool had_less)
{
    const char *seconds = kit_text("%.2g", grader.seconds);
    const char *found = kit_text("no answer after %s second%s", seconds,
                                 strcmp(seconds, "1") == 0 ? "" : "s");
    struct trace *trace = grader.trace;
    trace->called[sizeof trace->called - 1] = '\0';
    if (trace->called[0])
        found = kit_text("%s, in a call of %s", found, trace->called);
    if (trace->place)
        found = at_place(found, kit_text("0x%zx", trace->place));
    grader.limit = fmax(grader.limit / 5, 1); // do not wait long
    grader.stops++;
    broken("stopped", found,
           had_less ? "A loop that never ends? The time for this "
                      "exercise is used up by the tests before, and "
                      "this one had less of it."
           : grader.endless
               ? grader.endless
               : "A loop that never ends, or one whose time "
                 "grows too fast with n.");
}

bool kit_enter(void)
{
    *grader.trace = (struct trace){.loaded = false};
    if (ftruncate(grader.printed, 0) != 0)
        fail("cannot empty the file for what is printed");
    lseek(grader.printed, 0, SEEK_SET);
    fflush(NULL);
    int ends[2], status = 0;
    pid_t process = pipe(ends) == 0 ? fork() : -1;
    if (process < 0)
        fail("cannot start a process");
    if (process == 0) {
        become_student(ends[1]);
        return true;
    }
    close(ends[1]);
    bool less = time_left() < grader.allowed;
    bool ended = wait_for(process, ends[0], &status);
    close(ends[0]);
    char *printed = read_printed();
    char *report = find_report(printed);
    pass_on(printed, report);
    if (!ended)
        stopped(less);
    judge(status, report);
    return false;
}

// ---- the tests -----------------------------------------------------

static void put_cell(const char *text, char end)
{
    for (; text && *text; text++)
        putc(*text == '\t' || *text == '\n' ? ' ' : *text,
             grader.scores);
    putc(end, grader.scores);
}

// Among what is told of a failure.
static bool says(const struct kit_fault *fault, const char *words)
{
    const char *const told[] = {fault->expected, fault->found,
                                fault->cause};
    for (int k = 0; k < 3; k++)
        if (told[k] && strstr(told[k], words))
            return true;
    return false;
}

// Whether the tests go on.
static bool run_test(const struct kit_test *test)
{
    grader.status = "passed";
    grader.fault = (struct kit_fault){.where = NULL};
    grader.given[0] = '\0';
    grader.endless = NULL;
    grader.ratio = 0;
    if (setjmp(grader.end) == 0) {
        if (grader.lost)
            broken(grader.verdict, grader.lost, NULL);
        if (grader.stops >= STOPS_MAX)
            broken("stopped",
                   "not tried, because two tests before it did not end",
                   NULL);
        test->run(grader.seed);
    }
    bool passed = strcmp(grader.status, "passed") == 0;
    bool graded = strcmp(grader.status, "not graded") != 0;
    fprintf(grader.scores, "%s\t%d\t%d\t%s\t", test->name,
            passed ? test->points : grader.fault.points,
            graded ? test->points : 0, grader.status);
    put_cell(test->about, '\t');
    put_cell(grader.lost ? "" : kit_text("%ju", (uintmax_t)grader.seed),
             '\t');
    put_cell(grader.given, '\t');
    put_cell(grader.fault.where, '\t');
    put_cell(grader.fault.expected, '\t');
    put_cell(grader.fault.found, '\t');
    put_cell(grader.fault.cause, '\t');
    put_cell(grader.ratio > 0 ? kit_text("%.4g", grader.ratio) : "",
             '\n');
    fflush(grader.scores);
    const bool enough =
        grader.until && !passed && says(&grader.fault, grader.until);
    kit_next_case();
    return !enough;
}

static bool wanted(const char *name, char **names)
{
    if (!*names)
        return true;
    for (; *names; names++)
        if (strcmp(name, *names) == 0)
            return true;
    return false;
}

static void prepare(const char *scores)
{
    FILE *printed = tmpfile();
    grader.scores = fopen(scores, "w");
    grader.trace =
        mmap(NULL, sizeof *grader.trace, PROT_READ | PROT_WRITE,
             MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (!printed || !grader.scores || grader.trace == MAP_FAILED)
        fail("cannot write %s, or no memory", scores);
    grader.printed = fileno(printed);
    grader.file =
        grader.lost ? -1 : open(grader.library, O_RDONLY | O_CLOEXEC);
    if (!grader.lost && grader.file < 0)
        fail("cannot open %s", grader.library);
    grader.fence = SANITIZED || grader.lost ? -1 : own_fence();
    fprintf(grader.scores, "test\tpoints\tof\tstatus\tabout\tseed\t"
                           "given\twhere\texpected\tfound\tcause\t"
                           "ratio\n");
}

static bool read_options(int argc, char **argv)
{
    grader.seed = 1;
    grader.limit = 10;
    grader.verdict = "missing";
    for (int option;
         (option = getopt(argc, argv, "s:l:n:v:p:u:")) != -1;) {
        if (option == 's')
            grader.seed = strtoull(optarg, NULL, 0);
        else if (option == 'l')
            grader.limit = atof(optarg);
        else if (option == 'n')
            grader.lost = optarg;
        else if (option == 'v')
            grader.verdict = optarg;
        else if (option == 'p')
            grader.picture = optarg;
        else if (option == 'u')
            grader.until = optarg;
        else
            return false;
    }
    grader.allowed = grader.limit;
    grader.budget = CALLS_MAX * grader.limit;
    return true;
}

int main(int argc, char **argv)
{
    fail_as("grader");
    if (!read_options(argc, argv))
        return 2;
    argv += optind;
    if (argc - optind < 3)
        fail("say LIBRARY SOURCE SCORES");
    grader.library = argv[0];
    grader.source = argv[1];
    guard_judge();
    prepare(argv[2]);
    learn_to_tell();
    if (SANITIZED && !has_rules())
        puts("This system has limits to hold a program back, but no "
             "rules.");
    for (const struct kit_test *test = kit_tests; test->name; test++)
        if (wanted(test->name, argv + 3) && !run_test(test))
            break;
    bool bad = ferror(grader.scores);
    if (fclose(grader.scores) != 0 || bad)
        fail("cannot write %s", argv[2]);
    return 0;
}
