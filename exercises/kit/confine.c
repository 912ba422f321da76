// The rules are a filter for the kernel (seccomp): a list of system
// calls, with a condition on one argument where it matters. What is not
// in the list fails and has no effect.
#include "confine.h"
#include "fence.h"
#include <errno.h>
#include <fcntl.h>
#include <grp.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#if defined __linux__ && (defined __x86_64__ || defined __aarch64__)
#define RULES true
#ifdef __x86_64__
#define MACHINE AUDIT_ARCH_X86_64
#else
#define MACHINE AUDIT_ARCH_AARCH64
#endif
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#else
#define RULES false
#endif

// The stacks of so many threads fit into the memory that is allowed.
enum { NOBODY = 65534, THREADS_MAX = 200, DESCRIPTORS_MAX = 256 };

// KIT_RULES=no is how a test tries what is left without them.
static bool look_for_rules(void)
{
    const char *wanted = getenv("KIT_RULES");
    if (wanted && *wanted == 'n')
        return false;
#if RULES
    // With no filter given, a kernel that has them says so.
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, NULL) != 0 &&
           errno == EFAULT;
#else
    return false;
#endif
}

bool has_rules(void)
{
    static enum { UNKNOWN, NONE, SOME } rules = UNKNOWN;
    if (rules == UNKNOWN)
        rules = look_for_rules() ? SOME : NONE;
    return rules == SOME;
}

// ---- rules ---------------------------------------------------------

#if RULES
// Allows a call if its argument of this number & mask is the value, or
// always if mask is 0.
struct rule {
    uint32_t call, argument, mask, value;
};

static const struct rule computing[] = {
    // memory
    {__NR_mmap, 0, 0, 0},
    {__NR_munmap, 0, 0, 0},
    {__NR_mprotect, 0, 0, 0},
    {__NR_mremap, 0, 0, 0},
    {__NR_madvise, 0, 0, 0},
    {__NR_brk, 0, 0, 0},
    // threads, but no processes
    {__NR_clone, 0, CLONE_THREAD, CLONE_THREAD},
    {__NR_futex, 0, 0, 0},
    {__NR_set_robust_list, 0, 0, 0},
    {__NR_rseq, 0, 0, 0},
    {__NR_membarrier, 0, 0, 0},
    {__NR_sched_yield, 0, 0, 0},
    {__NR_sched_getaffinity, 0, 0, 0},
    {__NR_sched_setaffinity, 0, ~0u, 0}, // its own
    {__NR_getcpu, 0, 0, 0},
    {__NR_gettid, 0, 0, 0},
    {__NR_getpid, 0, 0, 0},
    {__NR_exit, 0, 0, 0},
    {__NR_exit_group, 0, 0, 0},
    // time
    {__NR_clock_gettime, 0, 0, 0},
    {__NR_clock_getres, 0, 0, 0},
    {__NR_gettimeofday, 0, 0, 0},
    {__NR_nanosleep, 0, 0, 0},
    {__NR_clock_nanosleep, 0, 0, 0},
    {__NR_restart_syscall, 0, 0, 0},
    // signals to itself
    {__NR_rt_sigaction, 0, 0, 0},
    {__NR_rt_sigprocmask, 0, 0, 0},
    {__NR_rt_sigreturn, 0, 0, 0},
    {__NR_sigaltstack, 0, 0, 0},
    // what it prints, and what is open already
    {__NR_write, 0, ~0u, STDOUT_FILENO},
    {__NR_write, 0, ~0u, STDERR_FILENO},
    {__NR_writev, 0, ~0u, STDOUT_FILENO},
    {__NR_writev, 0, ~0u, STDERR_FILENO},
    {__NR_read, 0, 0, 0},
    {__NR_lseek, 0, 0, 0},
    {__NR_close, 0, 0, 0},
    {__NR_fstat, 0, 0, 0},
    {__NR_newfstatat, 0, 0, 0},
    // what may be asked
    {__NR_getrandom, 0, 0, 0},
    {__NR_sysinfo, 0, 0, 0},
    {__NR_uname, 0, 0, 0},
    {__NR_getrusage, 0, 0, 0},
    {__NR_getrlimit, 0, 0, 0},
    {__NR_prlimit64, 2, ~0u, 0}, // where it is to be set, NULL
    {__NR_getuid, 0, 0, 0},
    {__NR_geteuid, 0, 0, 0},
#ifdef __x86_64__
    {__NR_time, 0, 0, 0},
    {__NR_arch_prctl, 0, 0, 0},
#endif
};

static const struct rule reading[] = {
    {__NR_openat, 2, ~0u, O_RDONLY},
    {__NR_openat, 2, ~0u, O_RDONLY | O_CLOEXEC},
    {__NR_pread64, 0, 0, 0},
    {__NR_write, 0, 0, 0}, // to say that it is loaded
    {__NR_readlinkat, 0, 0, 0},
    {__NR_prctl, 0, ~0u, PR_SET_NO_NEW_PRIVS}, // for the final rules
    {__NR_prctl, 0, ~0u, PR_SET_SECCOMP},
#ifdef __x86_64__
    {__NR_open, 1, ~0u, O_RDONLY},
    {__NR_open, 1, ~0u, O_RDONLY | O_CLOEXEC},
    {__NR_stat, 0, 0, 0},
    {__NR_readlink, 0, 0, 0},
#endif
};

enum {
    COMPUTING = sizeof computing / sizeof *computing,
    READING = sizeof reading / sizeof *reading,
    FILTER_MAX = 8 * (COMPUTING + READING + 8),
};

static struct sock_filter filter[FILTER_MAX];
static unsigned short length;

static void add(int code, int if_not, uint32_t k)
{
    filter[length++] =
        (struct sock_filter){(uint16_t)code, 0, (uint8_t)if_not, k};
}

static void load(size_t offset)
{
    add(BPF_LD | BPF_W | BPF_ABS, 0, (uint32_t)offset);
}

// Unless it is equal, so many of the next instructions are passed over.
static void must_equal(uint32_t value, int over)
{
    add(BPF_JMP | BPF_JEQ | BPF_K, over, value);
}

// The call's number is loaded, before and after.
static void allow(struct rule rule)
{
    size_t low = offsetof(struct seccomp_data, args) +
                 sizeof(uint64_t) * rule.argument;
    must_equal(rule.call, rule.mask ? 7 : 1);
    if (rule.mask) {
        load(low + sizeof(uint32_t));
        must_equal(0, 4);
        load(low);
        add(BPF_ALU | BPF_AND | BPF_K, 0, rule.mask);
        must_equal(rule.value, 1);
    }
    add(BPF_RET | BPF_K, 0, SECCOMP_RET_ALLOW);
    if (rule.mask)
        load(offsetof(struct seccomp_data, nr));
}

// Rules only ever take away: the strictest filter of all wins.
static void install(bool may_read)
{
    if (!has_rules())
        return;
    length = 0;
    load(offsetof(struct seccomp_data, arch));
    add(BPF_JMP | BPF_JEQ | BPF_K, 0, MACHINE);
    filter[length - 1].jt = 1; // over the next one
    add(BPF_RET | BPF_K, 0, SECCOMP_RET_KILL_PROCESS);
    load(offsetof(struct seccomp_data, nr));
    for (int r = 0; r < COMPUTING; r++)
        allow(computing[r]);
    for (int r = 0; may_read && r < READING; r++)
        allow(reading[r]);
    uint32_t self = (uint32_t)getpid();
    allow((struct rule){__NR_kill, 0, ~0u, self});
    allow((struct rule){__NR_tgkill, 0, ~0u, self});
    // The C library then starts a thread in the older way.
    must_equal(__NR_clone3, 1);
    add(BPF_RET | BPF_K, 0, SECCOMP_RET_ERRNO | ENOSYS);
    add(BPF_RET | BPF_K, 0, SECCOMP_RET_ERRNO | EPERM);
    struct sock_fprog program = {length, filter};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
        _exit(1);
}
#else
static void install(bool may_read)
{
    (void)may_read;
}
#endif

void confine_to_computing(void)
{
    install(false);
}

// ---- limits --------------------------------------------------------

static void limit(int resource, rlim_t most)
{
    setrlimit(resource, &(struct rlimit){most, most});
}

// The first line of a file of the system's; a stream would cost more
// than all the rest. Text that cannot be read is empty.
static const char *line_of(const char *name)
{
    static char line[128];
    int file = open(name, O_RDONLY | O_CLOEXEC);
    ssize_t length = file < 0 ? 0 : read(file, line, sizeof line - 1);
    line[length < 0 ? 0 : length] = '\0';
    if (file >= 0)
        close(file);
    return line;
}

// What is mapped already counts too, and a sanitizer maps terabytes.
static void limit_memory(size_t most)
{
    size_t pages = strtoull(line_of("/proc/self/statm"), NULL, 10);
    if (pages > 0)
        limit(RLIMIT_AS, pages * sysconf(_SC_PAGESIZE) + most);
}

// Threads count together with all else that runs for the same user.
static void limit_threads(void)
{
    const char *all = strchr(line_of("/proc/loadavg"), '/');
    if (all)
        limit(RLIMIT_NPROC, strtoull(all + 1, NULL, 10) + THREADS_MAX);
}

// If memory runs out, it is this process that the system should end.
static void volunteer(void)
{
    int file = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
    if (file < 0)
        return;
    ssize_t written = write(file, "1000", 4);
    (void)written; // it is only a wish
    close(file);
}

static int processors(void)
{
    static int count;
    if (count == 0)
        count = (int)sysconf(_SC_NPROCESSORS_ONLN);
    return count;
}

static void become_nobody(void)
{
    if (geteuid() == 0 && (setgroups(0, NULL) != 0 ||
                           setgid(NOBODY) != 0 || setuid(NOBODY) != 0))
        _exit(1);
}

void give_place(const char *place)
{
    if (geteuid() == 0 && chown(place, NOBODY, NOBODY) != 0)
        _exit(1);
}

static void close_from(int first, int last)
{
#ifdef SYS_close_range
    if (first > last || syscall(SYS_close_range, first, last, 0) == 0)
        return;
#endif
    for (int k = first; k <= last && k < DESCRIPTORS_MAX; k++)
        close(k);
}

static void close_all_but(const int *keep)
{
    int first = STDERR_FILENO + 1;
    for (;;) {
        int next = INT_MAX; // to be kept
        for (int k = 0; k < KEEP_MAX; k++)
            if (keep[k] >= first && keep[k] < next)
                next = keep[k];
        close_from(first, next - 1);
        if (next == INT_MAX)
            return;
        first = next + 1;
    }
}

static void put_limits(struct limits limits)
{
    setsid();
    close_all_but(limits.keep);
    volunteer();
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, limits.printed);
    limit(RLIMIT_CPU, (rlim_t)ceil(limits.seconds + 1) * processors());
    limit_memory(limits.memory);
    limit_threads();
    become_nobody();
}

void confine_tool(struct limits limits, int file, const char *place)
{
    int fence = build_fence(file, place, true);
    limits.keep[KEEP_MAX - 1] = fence;
    put_limits(limits);
    enter_fence(fence);
    alarm((unsigned)ceil(limits.seconds));
}

void confine(struct limits limits, int fence)
{
    put_limits(limits);
#ifdef __linux__
    prctl(PR_SET_DUMPABLE, 1); // or it could not open its own library
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    enter_fence(fence);
    install(true);
}

// ---- the judge -----------------------------------------------------

void guard_judge(void)
{
    processors(); // which its children need not find out again
    has_rules();
#ifdef __linux__
    prctl(PR_SET_DUMPABLE, 0);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
#endif
}

// Ends whoever is our child now; their children will be the next ones.
static void end_generation(void)
{
    char name[64];
    snprintf(name, sizeof name, "/proc/self/task/%d/children",
             (int)getpid());
    FILE *file = fopen(name, "r");
    if (!file)
        return;
    for (int child; fscanf(file, "%d", &child) == 1;)
        kill(child, SIGKILL);
    fclose(file);
}

// LLVM's OpenMP library leaves a file behind for a process that ends as
// ours do.
static void remove_traces(pid_t child)
{
    char name[64];
    snprintf(name, sizeof name, "/dev/shm/__KMP_REGISTERED_LIB_%d_%d",
             (int)child, (int)getuid());
    unlink(name);
}

int end_of(pid_t child)
{
#ifdef SYS_pidfd_open
    return (int)syscall(SYS_pidfd_open, child, 0);
#else
    (void)child;
    return -1;
#endif
}

void end_children(pid_t child)
{
    enum { NAP = 1000000, NAPS_MAX = 5000 }; // ns
    kill(child, SIGKILL);
    kill(-child, SIGKILL);
    for (int naps = 0; naps < NAPS_MAX;) {
        pid_t ended = waitpid(-1, NULL, WNOHANG);
        if (ended < 0)
            break;
        if (ended > 0)
            continue;
        end_generation();
        nanosleep(&(struct timespec){.tv_nsec = NAP}, NULL);
        naps++;
    }
    remove_traces(child);
}
