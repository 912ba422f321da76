// Writes to a new file beside the old one, which is renamed when all of
// it is on the disk, or removed if the program ends before. There is
// one such file in a run of near, and what cleans up after a failure
// must be able to find it: hence the state.
#include "near/write.h"
#include "common/fail.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

void insist_on_output(void)
{
    if (fcntl(STDERR_FILENO, F_GETFD) < 0)
        exit(2);
    if (fcntl(STDOUT_FILENO, F_GETFD) < 0)
        fail("cannot write standard output: it is closed");
}

static FILE *out;
static int failure;                 // an errno, of the first
static const char *target;          // as messages call it
static char path[PATH_MAX];         // where the file shall be
static char partial[PATH_MAX + 32]; // where it is until then, or ""
void write_abandon(void)
{
    if (*partial)
        unlink(partial);
}

static void abandon_and_die(int signal)
{
    write_abandon();
    struct sigaction as_usual = {.sa_handler = SIG_DFL};
    sigaction(signal, &as_usual, NULL);
    raise(signal);
}

// A signal that somebody chose to ignore, as nohup does, stays so.
static void abandon_on_signals(void)
{
    static const int signals[] = {SIGHUP,  SIGINT,  SIGQUIT,
                                  SIGPIPE, SIGALRM, SIGTERM,
                                  SIGUSR1, SIGUSR2, SIGXCPU};
    struct sigaction action = {.sa_handler = abandon_and_die}, old;
    for (size_t k = 0; k < sizeof signals / sizeof *signals; k++) {
        sigaction(signals[k], NULL, &old);
        if (old.sa_handler != SIG_IGN)
            sigaction(signals[k], &action, NULL);
    }
    signal(SIGXFSZ, SIG_IGN); // a file too large is an error to report
    atexit(write_abandon);
}

// An existing target is followed to what its links point at, and lends
// the new file its rights.
static FILE *open_partial(const char *name, const struct stat *existing)
{
    if (!existing || !realpath(name, path))
        snprintf(path, sizeof path, "%s", name);
    const char *slash = strrchr(path, '/');
    int folder = slash ? (int)(slash + 1 - path) : 0;
    snprintf(partial, sizeof partial, "%.*s.near.%ld.partial", folder,
             path, (long)getpid());
    FILE *file = fopen(partial, "wx");
    if (!file)
        *partial = 0;
    else if (existing)
        fchmod(fileno(file), existing->st_mode & 07777);
    return file;
}

static bool is_standard_output(const struct stat *file)
{
    struct stat standard;
    return fstat(STDOUT_FILENO, &standard) == 0 &&
           file->st_dev == standard.st_dev &&
           file->st_ino == standard.st_ino;
}

void write_open(const char *name)
{
    struct stat there, link;
    bool standard = strcmp(name, "-") == 0;
    bool exists = !standard && stat(name, &there) == 0;
    standard = standard || (exists && is_standard_output(&there));
    target = standard ? "standard output" : name;
    abandon_on_signals();
    if (standard)
        out = stdout;
    else if (exists && !S_ISREG(there.st_mode))
        out = fopen(name, "w");
    else if (exists && access(name, W_OK) == 0)
        out = open_partial(name, &there);
    else if (!exists && lstat(name, &link) != 0) // no link to nowhere
        out = open_partial(name, NULL);
    if (!out)
        fail("cannot write %s: %s", target, strerror(errno));
}

bool write_is_file(void)
{
    struct stat file;
    return fstat(fileno(out), &file) == 0 && S_ISREG(file.st_mode);
}

void write_bytes(const char *bytes, size_t count)
{
    if (!failure && fwrite(bytes, 1, count, out) != count)
        failure = errno;
}

// The new file is on the disk before it takes the place of an old one:
// a machine that stops has one of them.
static bool commit(void)
{
    if (fflush(out) != 0 || (*partial && fsync(fileno(out)) != 0))
        return false;
    return (out == stdout || fclose(out) == 0) &&
           (!*partial || rename(partial, path) == 0);
}

void write_close(void)
{
    if (!failure && !commit())
        failure = errno;
    if (failure)
        fail("cannot write %s: %s", target, strerror(failure));
    *partial = 0;
}
