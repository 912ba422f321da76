// The grader: runs the tests of an exercise against a student's file.
//
//   GRADER [-s SEED] [-l SECONDS] [-n WHY -v VERDICT] [-p PICTURE]
//          LIBRARY SOURCE SCORES [TEST...]
//
// -n fails every test for this reason and runs none: no seed would
// change that, and the table has none. PICTURE becomes
// what wrong.gp draws, if a test has failed that can be drawn.
//
// SCORES becomes a table, tab-separated, one row a test, with all that
// a report needs. What the student's code prints is passed on, but is
// never taken for a result: the table is out of its reach.
#include "kit.h"
#include "common/clock.h"
#include "common/fail.h"
#include "common/generate.h"
#include "confine.h"
#include <dlfcn.h>
#include <fcntl.h>
#include <math.h>
#include <omp.h>
#include <poll.h>
#include <setjmp.h>
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
    ARRAYS_MAX = 64,
    OUTPUT_MAX = 1 << 20, // bytes that a call may print
    MEMORY_MAX = 4,       // GB that it may ask for
    CALLS_MAX = 20,       // limits that all calls together may take
    SHOWN_MAX = 12,       // lines of its output that are passed on
    REPORT_MAX = 300,     // bytes of a sanitizer's sentence
    NAP = 10,             // ms
    SANITIZER_STATUS = 99,
    POISON = 0xa5,
};

struct array {
    const char *name;
    char *pages, *start, *end; // end: where the closing page begins
    size_t size;               // of an element
    bool input;
};

// What the student's process leaves behind, besides the outputs.
struct trace {
    bool loaded, finished;
    char problem[256]; // why its file cannot be used
    char *address;     // of an access that the machine refused
};

static struct {
    const char *source; // as the student knows it
    const char *library;
    int file;       // the library, open
    double limit;   // seconds a call may take
    double allowed; // and might, before time was lost
    double budget;  // and all that are still to come
    double seconds; // that the last one took, by the clock
    double processor_seconds;
    int printed; // the file that catches what a call prints
    FILE *scores;
    const char *picture; // the file to draw; NULL: done, or not wanted
    struct trace *trace;

    // of the test that runs
    struct array arrays[ARRAYS_MAX];
    int array_count;
    char given[256], text[4096];
    size_t text_length;
    const char *status;
    struct kit_fault fault;
    jmp_buf end;
} grader;

// In the student's process only.
static struct {
    void *library;
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
    vsnprintf(grader.given, sizeof grader.given, format, arguments);
    va_end(arguments);
}

// ---- arrays --------------------------------------------------------

static void *add_array(const char *name, size_t count, size_t size,
                       bool input)
{
    if (grader.array_count == ARRAYS_MAX)
        fail("a test has too many arrays: call kit_next_case");
    size_t page = sysconf(_SC_PAGESIZE);
    size_t bytes = (count * size + page - 1) / page * page + page;
    char *pages =
        mmap(NULL, bytes + page, PROT_READ | PROT_WRITE,
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

// The name of the file that is open, for this process.
static const char *loaded_name(void)
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

static void become_student(int pipe)
{
    int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(grader.printed, STDOUT_FILENO);
    dup2(grader.printed, STDERR_FILENO);
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ); // a crash loses nothing
    omp_get_num_procs(); // has OpenMP look around while it may
    protect_arrays();
    catch_refused_accesses();
    confine((struct limits){.seconds = grader.limit,
                            .printed = OUTPUT_MAX,
                            .memory = memory_limit(),
                            .keep = {grader.file, pipe}});
    student.library = dlopen(loaded_name(), RTLD_NOW | RTLD_LOCAL);
    if (!student.library) {
        const char *why = dlerror(), *key = "undefined symbol: ";
        const char *symbol = strstr(why, key);
        if (symbol)
            give_up("it uses but does not define",
                    symbol + strlen(key));
        give_up("it cannot be loaded:", why);
    }
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

// The first that can be drawn is drawn.
static void draw(const struct kit_picture *picture)
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
    fclose(file);
    grader.picture = NULL;
}

_Noreturn void kit_wrong(struct kit_fault fault)
{
    grader.fault = fault;
    draw(&fault.picture);
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

_Noreturn static void broken(const char *status, const char *found,
                             const char *cause)
{
    grader.fault = (struct kit_fault){.found = found, .cause = cause};
    end_test(status);
}

static char *read_printed(void)
{
    static char text[OUTPUT_MAX + 1];
    ssize_t got = pread(grader.printed, text, OUTPUT_MAX, 0);
    text[got < 0 ? 0 : got] = '\0';
    return text;
}

// Where a sanitizer's report begins, or else the end of the text.
static char *find_report(char *printed)
{
    static const char *const signs[] = {
        "AddressSanitizer:", "=================", ": runtime error: "};
    char *begin = printed + strlen(printed);
    for (int s = 0; s < 3; s++) {
        char *sign = strstr(printed, signs[s]);
        if (sign && sign < begin)
            begin = sign;
    }
    while (*begin && begin > printed && begin[-1] != '\n')
        begin--;
    return begin;
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

// The line of the student's file in which the machine code at this
// place of its library stands, or 0.
static int line_at(const char *place)
{
    int ends[2];
    pid_t process = pipe(ends) == 0 ? fork() : -1;
    if (process < 0)
        return 0;
    if (process == 0) {
        dup2(ends[1], STDOUT_FILENO);
        execlp("addr2line", "addr2line", "-s", "-e", grader.library,
               place, (char *)NULL);
        _exit(1);
    }
    close(ends[1]);
    char said[512] = "";
    int line = 0;
    ssize_t got = read(ends[0], said, sizeof said - 1);
    close(ends[0]);
    waitpid(process, NULL, 0);
    const char *name = strrchr(grader.source, '/');
    name = name ? name + 1 : grader.source;
    size_t length = strlen(name);
    if (got > 0 && strncmp(said, name, length) == 0)
        sscanf(said + length, ":%d", &line);
    return line;
}

// The line of the student's file that a report names first, or 0.
static int line_in(const char *report)
{
    enum { FRAMES_MAX = 8 };
    const char *frame = report;
    for (int frames = 0; frames < FRAMES_MAX; frames++) {
        char place[32];
        frame = strstr(frame, loaded_name());
        if (!frame)
            break;
        frame += strlen(loaded_name());
        if (sscanf(frame, "+%31[0-9a-fx]", place) != 1)
            continue;
        int line = line_at(place);
        if (line > 0)
            return line;
    }
    const char *name = strrchr(grader.source, '/');
    name = name ? name + 1 : grader.source;
    for (; (report = strstr(report, name)); report++) {
        int line;
        if (sscanf(report + strlen(name), ":%d", &line) == 1)
            return line;
    }
    return 0;
}

static const char *at_line(const char *what, int line)
{
    if (line == 0)
        return what;
    return kit_text("%s, in line %d of %s", what, line, grader.source);
}

// An access that the machine refused: to which array?
static void judge_access(char *address, int line)
{
    size_t page = sysconf(_SC_PAGESIZE);
    for (int a = 0; a < grader.array_count; a++) {
        struct array *array = &grader.arrays[a];
        if (address < array->pages || address >= array->end + page)
            continue;
        if (address < array->end)
            broken(
                "crashed",
                at_line(kit_text("it writes to %s", array->name), line),
                "This array may only be read.");
        size_t count = (array->end - array->start) / array->size;
        broken("crashed",
               at_line(kit_text("it touches element %td of %s, which "
                                "has %zu",
                                (address - array->start) /
                                    (ptrdiff_t)array->size,
                                array->name, count),
                       line),
               "An index runs past the end: the last one is the "
               "number of elements minus 1.");
    }
    broken("crashed",
           at_line("it uses memory that is not its own", line),
           "An index out of range, a pointer that was never set, or a "
           "recursion without end.");
}

// What the sanitizers call it, and what it usually is.
static const char *const sanitizer_words[][2] = {
    {"stack-overflow",
     "A recursion without end, or a huge local array."},
    {"heap-buffer-overflow",
     "An index runs past the end of memory that you allocated."},
    {"stack-buffer-overflow",
     "An index runs past the end of a local array."},
    {"global-buffer-overflow",
     "An index runs past the end of a global array."},
    {"use-after-poison",
     "An index became negative: this is in front of an array."},
    {"heap-use-after-free", "It is used after free()."},
    {"double-free", "The same memory is released twice."},
    {"bad-free", "free() is for what malloc() gave, and nothing else."},
    {"out of memory", "Is memory allocated in a loop without end?"},
    {"Failed to mmap", "Is memory allocated in a loop without end?"},
    {"out of bounds", "An index runs past the end of an array."},
    {"signed integer overflow",
     "The result does not fit: use a wider type, and convert before "
     "you multiply."},
    {"shift exponent", "A shift by as many bits as the type has."},
    {"division by zero", "What if there is nothing to divide by?"},
    {"outside the range of representable values",
     "A double too large, negative or NaN was converted to an integer: "
     "test it first."},
    {"null pointer", "A pointer that was never set, or a failed "
                     "allocation."},
    {"SEGV", "An index out of range, a pointer that was never set, or "
             "a recursion without end."},
};

static void judge_report(const char *report)
{
    const char *key = "runtime error: ";
    const char *what = strstr(report, key);
    if (what) {
        what += strlen(key);
    } else {
        key = "ERROR: AddressSanitizer: ";
        what = strstr(report, key);
        what = what ? what + strlen(key) : report;
    }
    int length = strcspn(what, "\n");
    const char *address = strstr(what, " on ");
    if (address && address - what < length)
        length = address - what;
    if (length > REPORT_MAX) // it may be the student's own invention
        length = REPORT_MAX;
    const char *cause = NULL;
    int words = sizeof sanitizer_words / sizeof *sanitizer_words;
    for (int w = words - 1; w >= 0; w--)
        if (strstr(report, sanitizer_words[w][0]))
            cause = sanitizer_words[w][1];
    broken("crashed",
           at_line(kit_text("%.*s", length, what), line_in(report)),
           cause);
}

static void judge_signal(int signal)
{
    switch (signal) {
    case SIGFPE:
        broken("crashed", "it divides an integer by zero",
               "What if there is nothing to divide by?");
    case SIGABRT:
        broken(
            "crashed", "it ended itself with abort() or assert()",
            "If it was assert(), the line printed above says which.");
    case SIGXFSZ:
        broken("crashed", "it prints more than a megabyte",
               "Remove the printing, or the loop that never ends.");
    case SIGKILL:
        broken("crashed", "it was ended from outside",
               "Most often it asked for more memory than there is.");
    default:
        broken("crashed", kit_text("it ended with signal %d", signal),
               NULL);
    }
}

static void judge(int status, const char *report)
{
    struct trace *trace = grader.trace;
    if (trace->address && (!SANITIZED || strstr(report, "SEGV")))
        judge_access(trace->address, line_in(report));
    if (*report && WIFEXITED(status) &&
        WEXITSTATUS(status) == SANITIZER_STATUS)
        judge_report(report);
    if (WIFSIGNALED(status))
        judge_signal(WTERMSIG(status));
    if (trace->problem[0])
        broken("missing", kit_text("%s", trace->problem),
               kit_text("Is every name in %s spelled as in the text?",
                        grader.source));
    if (!trace->loaded || !trace->finished)
        broken("crashed",
               kit_text("it ended the program, with status %d",
                        WEXITSTATUS(status)),
               "A function answers with return; exit() ends "
               "everything.");
    for (int a = 0; a < grader.array_count; a++)
        for (char *c = grader.arrays[a].pages;
             c < grader.arrays[a].start; c++)
            if ((unsigned char)*c != POISON)
                broken("crashed",
                       kit_text("it wrote in front of %s",
                                grader.arrays[a].name),
                       "An index became negative.");
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
    bool ended;
    for (bool open = true;;) {
        ended = wait4(process, status, WNOHANG, &used) == process;
        now = clock_ns();
        if (ended || (now - begin) * 1e-9 > limit)
            break;
        // A child of its own may hold the pipe, too: do not sleep long.
        struct pollfd said = {open ? pipe : -1, POLLIN, 0};
        if (poll(&said, 1, open ? NAP : 1) == 1) {
            char byte;
            open = read(pipe, &byte, 1) == 1;
            if (open && start == begin)
                start = clock_ns();
        }
    }
    grader.seconds = (now - start) * 1e-9;
    grader.processor_seconds =
        in_seconds(used.ru_utime) + in_seconds(used.ru_stime);
    grader.budget -= (now - begin) * 1e-9;
    end_children(process);
    return ended;
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
    if (!ended) {
        const char *seconds = kit_text("%.2g", grader.seconds);
        const char *found =
            kit_text("no answer after %s second%s", seconds,
                     strcmp(seconds, "1") == 0 ? "" : "s");
        grader.limit = fmax(grader.limit / 2, 1); // do not wait long
        broken("stopped", found,
               less ? "A loop that never ends? The time for this "
                      "exercise is used up by the tests before, and "
                      "this one had less of it."
                    : "A loop that never ends, or one whose time "
                      "grows too fast with n.");
    }
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

static void run_test(const struct kit_test *test, uint64_t seed,
                     const char *lost, const char *verdict)
{
    grader.status = "passed";
    grader.fault = (struct kit_fault){.where = NULL};
    grader.given[0] = '\0';
    if (setjmp(grader.end) == 0) {
        if (lost)
            broken(verdict, lost, NULL);
        test->run(seed);
    }
    bool passed = strcmp(grader.status, "passed") == 0;
    bool graded = strcmp(grader.status, "not graded") != 0;
    fprintf(grader.scores, "%s\t%d\t%d\t%s\t", test->name,
            passed ? test->points : grader.fault.points,
            graded ? test->points : 0, grader.status);
    put_cell(test->about, '\t');
    put_cell(lost ? "" : kit_text("%ju", (uintmax_t)seed), '\t');
    put_cell(grader.given, '\t');
    put_cell(grader.fault.where, '\t');
    put_cell(grader.fault.expected, '\t');
    put_cell(grader.fault.found, '\t');
    put_cell(grader.fault.cause, '\n');
    fflush(grader.scores);
    kit_next_case();
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
    grader.file = open(grader.library, O_RDONLY);
    fprintf(grader.scores, "test\tpoints\tof\tstatus\tabout\tseed\t"
                           "given\twhere\texpected\tfound\tcause\n");
}

int main(int argc, char **argv)
{
    fail_as("grader", NULL);
    uint64_t seed = 1;
    const char *lost = NULL, *verdict = "missing";
    grader.limit = 10;
    for (int option;
         (option = getopt(argc, argv, "s:l:n:v:p:")) != -1;) {
        if (option == 's')
            seed = strtoull(optarg, NULL, 0);
        else if (option == 'l')
            grader.limit = atof(optarg);
        else if (option == 'n')
            lost = optarg;
        else if (option == 'v')
            verdict = optarg;
        else if (option == 'p')
            grader.picture = optarg;
        else
            return 2;
    }
    if (argc - optind < 3)
        fail("say LIBRARY SOURCE SCORES");
    grader.library = argv[optind];
    grader.source = argv[optind + 1];
    grader.allowed = grader.limit;
    grader.budget = CALLS_MAX * grader.limit;
    prepare(argv[optind + 2]);
    guard_judge();
    if (SANITIZED && !has_rules())
        puts("This system has limits to hold a program back, but no "
             "rules.");
    for (const struct kit_test *test = kit_tests; test->name; test++)
        if (wanted(test->name, argv + optind + 3))
            run_test(test, seed, lost, verdict);
    return 0;
}
