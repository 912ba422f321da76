// Says what a student's process has done, and what it probably did
// wrong: from how it ended, what a sanitizer reported, the address of a
// refused access, and what stands around the arrays.
#include "confine.h"
#include "grader.h"
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
    REPORT_MAX = 300, // bytes of a sanitizer's sentence
    SANITIZER_STATUS = 99,
};

char *find_report(char *printed)
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

// ---- where it happened ---------------------------------------------

static const char *source_name(void)
{
    const char *slash = strrchr(grader.source, '/');
    return slash ? slash + 1 : grader.source;
}

// The line of the student's file in which the machine code at this
// place of its library stands, or 0. The library may hold anything, so
// the tool that reads it has limits.
static int line_at(const char *place)
{
    const struct limits limits = {.seconds = 5,
                                  .printed = 1 << 20,
                                  .memory = 1 << 30,
                                  .keep = {grader.file, -1, -1}};
    int ends[2];
    pid_t process = pipe(ends) == 0 ? fork() : -1;
    if (process < 0)
        return 0;
    if (process == 0) {
        dup2(ends[1], STDOUT_FILENO);
        fcntl(grader.file, F_SETFD, 0);
        confine_tool(limits, grader.file, NULL);
        execlp("addr2line", "addr2line", "-s", "-e", loaded_name(),
               place, (char *)NULL);
        _exit(1);
    }
    close(ends[1]);
    char said[512] = "";
    int line = 0;
    ssize_t got = read(ends[0], said, sizeof said - 1);
    close(ends[0]);
    waitpid(process, NULL, 0);
    const char *name = source_name();
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
    const char *name = source_name();
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

const char *at_place(const char *what, const char *place)
{
    return at_line(what, line_at(place));
}

// ---- what happened -------------------------------------------------

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
    {"misaligned address",
     "An aligned load or store needs an address that is a multiple of "
     "its size; loadu and storeu do not."},
    {"null pointer", "A pointer that was never set, or a failed "
                     "allocation."},
    {"SEGV", "An index out of range, a pointer that was never set, or "
             "a recursion without end."},
};

static void judge_report(const char *report)
{
    static const char *const keys[] = {"ERROR: AddressSanitizer: ",
                                       "runtime error: "};
    const char *what = report;
    for (int k = 0; k < 2; k++) {
        const char *key = strstr(report, keys[k]);
        what = key ? key + strlen(keys[k]) : what;
    }
    int length = strcspn(what, "\n");
    const char *address = strstr(what, " on ");
    if (address && address - what < length)
        length = address - what;
    if (length > REPORT_MAX) // it may be the student's own invention
        length = REPORT_MAX;
    const int words = sizeof sanitizer_words / sizeof *sanitizer_words;
    const char *cause = NULL;
    for (int w = 0; w < words && !cause; w++)
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
    case SIGSEGV: // at an address that the system does not tell
        broken("crashed", "it uses an address that is none",
               "A pointer that was never set; or an aligned load or "
               "store where the address is no multiple of its size: "
               "loadu and storeu do not mind.");
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

static void judge_fronts(void)
{
    for (int a = 0; a < grader.array_count; a++)
        for (char *c = grader.arrays[a].pages;
             c < grader.arrays[a].start; c++)
            if ((unsigned char)*c != POISON)
                broken("crashed",
                       kit_text("it wrote in front of %s",
                                grader.arrays[a].name),
                       "An index became negative.");
}

void judge(int status, const char *report)
{
    struct trace *trace = grader.trace;
    if (trace->address &&
        (!kit_is_sanitized() || strstr(report, "SEGV")))
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
    judge_fronts();
}
