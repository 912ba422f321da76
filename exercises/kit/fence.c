// Landlock's rules name folders by open descriptors; what no rule names
// cannot be opened. Its system calls have no names in older C
// libraries.
#include "fence.h"
#include "common/fail.h"
#include <fcntl.h>
#include <stddef.h>
#include <stdint.h>
#include <unistd.h>
#if defined __linux__ && __has_include(<linux/landlock.h>)
#define FENCES true
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#else
#define FENCES false
#endif

#if FENCES
// What compiling, linking and running takes. Nothing of it is secret.
static const char *const needed[] = {
    "/bin",
    "/lib",
    "/lib32",
    "/lib64",
    "/sbin",
    "/usr/bin",
    "/usr/include",
    "/usr/lib",
    "/usr/lib32",
    "/usr/lib64",
    "/usr/libexec",
    "/usr/local/bin",
    "/usr/local/lib",
    "/usr/local/include",
    "/etc/ld.so.cache",
    "/dev/null",
    "/proc/cpuinfo",
    "/sys/devices/system/cpu",
};

enum {
    LOOK = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE |
           LANDLOCK_ACCESS_FS_READ_DIR,
    LOOK_AT_FILE =
        LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE,
    WRITE_FILE = LANDLOCK_ACCESS_FS_WRITE_FILE,
    ALL =
        (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1, // of the first version
};

static long version(void)
{
    return syscall(SYS_landlock_create_ruleset, NULL, (size_t)0,
                   LANDLOCK_CREATE_RULESET_VERSION);
}

bool can_fence(void)
{
    return version() >= 1;
}

// A folder can be given more rights than a file.
static void open_gate(int rules, int file, uint64_t rights)
{
    struct landlock_path_beneath_attr gate = {rights, file};
    if (syscall(SYS_landlock_add_rule, rules,
                LANDLOCK_RULE_PATH_BENEATH, &gate, 0) == 0)
        return;
    gate.allowed_access = rights & (LOOK_AT_FILE | WRITE_FILE);
    syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH,
            &gate, 0);
}

static void open_gate_at(int rules, const char *path, uint64_t rights)
{
    int file = open(path, O_PATH | O_CLOEXEC);
    if (file < 0)
        return;
    open_gate(rules, file, rights);
    close(file);
}

int build_fence(int own, const char *place, bool self)
{
    if (!can_fence())
        return -1;
    uint64_t handled = ALL;
    struct landlock_ruleset_attr closed = {.handled_access_fs =
                                               handled};
    int rules = (int)syscall(SYS_landlock_create_ruleset, &closed,
                             sizeof closed, 0);
    if (rules < 0)
        fail("cannot build a fence");
    for (size_t k = 0; k < sizeof needed / sizeof *needed; k++)
        open_gate_at(rules, needed[k], LOOK);
    open_gate_at(rules, "/dev/null", LOOK | WRITE_FILE);
    if (self)
        open_gate_at(rules, "/proc/self", LOOK);
    if (own >= 0)
        open_gate(rules, own, LOOK_AT_FILE);
    if (place)
        open_gate_at(rules, place, ALL);
    return rules;
}

void enter_fence(int fence)
{
    if (fence < 0)
        return;
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        syscall(SYS_landlock_restrict_self, fence, 0) != 0)
        _exit(1);
    close(fence);
}
#else
bool can_fence(void)
{
    return false;
}

int build_fence(int own, const char *place, bool self)
{
    (void)own;
    (void)place;
    (void)self;
    return -1;
}

void enter_fence(int fence)
{
    (void)fence;
}
#endif
