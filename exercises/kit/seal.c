// Runs a compiler on what somebody handed in:
//
//   seal SECONDS PLACE COMMAND...   in the folder PLACE
//   seal                            says whether there is a fence
//
// It ends after so many seconds by the clock, with all that it started.
// It has the limits of a student's program, and as root's child it is
// nobody's; PLACE becomes nobody's then. Where there can be a fence, it
// reads what compilers need, and PLACE, and nothing else: no solutions,
// no tests, no device, no file of the system's. The status is that of
// the command, or 2 if there was none or its time was over.
#include "common/clock.h"
#include "common/fail.h"
#include "confine.h"
#include "fence.h"
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { NAP = 2000000 }; // ns

// Nobody may be shut out of the folders that the path names.
static void keep_path(void)
{
    static char path[1 << 16];
    const char *given = getenv("PATH");
    snprintf(path, sizeof path, "%s:/usr/local/bin:/usr/bin:/bin",
             given ? given : "");
    setenv("PATH", path, 1);
}

static _Noreturn void run(double seconds, const char *place,
                          char **command)
{
    const size_t output = 100u << 20, memory = (size_t)4 << 30;
    if (chdir(place) != 0)
        fail("there is no folder %s", place);
    setenv("TMPDIR", ".", 1);
    keep_path();
    give_place(".");
    confine_tool((struct limits){.seconds = seconds,
                                 .printed = output,
                                 .memory = memory,
                                 .keep = {-1, -1, -1}},
                 -1, ".");
    execvp(*command, command);
    fail("cannot run %s", *command);
}

int main(int argc, char **argv)
{
    fail_as("compiling");
    if (argc < 4)
        return can_fence() ? 0 : 1;
    double seconds = atof(argv[1]);
    int64_t begin = clock_ns();
    guard_judge();
    pid_t process = fork();
    if (process < 0)
        fail("cannot start a process");
    if (process == 0)
        run(seconds, argv[2], argv + 3);
    int status = 0;
    bool ended;
    while (!(ended = waitpid(process, &status, WNOHANG) == process) &&
           (clock_ns() - begin) * 1e-9 < seconds)
        nanosleep(&(struct timespec){.tv_nsec = NAP}, NULL);
    end_children(process);
    if (!ended)
        fail("stopped after %g seconds", seconds);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
