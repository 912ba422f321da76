// The hooks that the compiler calls, and what it calls them: see
// slow_motion.h. Locks and barriers are the OpenMP library's and stay
// as they are; atomic operations are done atomically, after a nap if
// they write.
#include "slow_motion.h"
#include "common/random.h"
#include <omp.h>
#include <stdatomic.h>
#include <stdint.h>
#include <time.h>

static const double longest_nap = 200e-6; // seconds
static bool slow;

void slow_motion(bool on)
{
    slow = on;
}

static void nap(void)
{
    static _Atomic uint64_t naps;
    if (!slow || !omp_in_parallel())
        return;
    struct random random = {naps++};
    double seconds = longest_nap * random_uniform(&random);
    nanosleep(&(struct timespec){.tv_nsec = (long)(seconds * 1e9)},
              NULL);
}

// The hooks get an address, and some a size; none of it matters here.
#define HOOK(name, action)    \
    void __tsan_##name(void); \
    void __tsan_##name(void)  \
    {                         \
        action;               \
    }
#define HOOKS_OF_SIZE(size)             \
    HOOK(read##size, (void)0)           \
    HOOK(unaligned_read##size, (void)0) \
    HOOK(write##size, nap())            \
    HOOK(unaligned_write##size, nap())  \
    HOOK(read_write##size, nap())       \
    HOOK(unaligned_read_write##size, nap())

HOOK(init, (void)0)
HOOK(func_entry, (void)0)
HOOK(func_exit, (void)0)
HOOK(read_range, (void)0)
HOOK(write_range, nap())
HOOK(atomic_thread_fence, atomic_thread_fence(memory_order_seq_cst))
HOOKS_OF_SIZE(1)
HOOKS_OF_SIZE(2)
HOOKS_OF_SIZE(4)
HOOKS_OF_SIZE(8)
HOOKS_OF_SIZE(16)

// Between a look and a store, each of them atomic, another thread may
// come. compare_exchange_val does not nap: clang makes loops with it
// that the program does not have, and they lose nothing. Whatever order
// was asked for, the strictest will do. Memory orders come last and are
// left where they are.
#define FETCH(bits, T, name)                                      \
    T __tsan_atomic##bits##_fetch_##name(T *, T);                 \
    T __tsan_atomic##bits##_fetch_##name(T *at, T with)           \
    {                                                             \
        nap();                                                    \
        return __atomic_fetch_##name(at, with, __ATOMIC_SEQ_CST); \
    }
#define COMPARE(bits, T, strength)                                    \
    bool __tsan_atomic##bits##_compare_exchange_##strength(T *, T *,  \
                                                           T);        \
    bool __tsan_atomic##bits##_compare_exchange_##strength(           \
        T *at, T *expected, T with)                                   \
    {                                                                 \
        nap();                                                        \
        return __atomic_compare_exchange_n(at, expected, with, false, \
                                           __ATOMIC_SEQ_CST,          \
                                           __ATOMIC_SEQ_CST);         \
    }
#define ATOMICS(bits, T)                                            \
    T __tsan_atomic##bits##_load(T *);                              \
    T __tsan_atomic##bits##_load(T *at)                             \
    {                                                               \
        return __atomic_load_n(at, __ATOMIC_SEQ_CST);               \
    }                                                               \
    void __tsan_atomic##bits##_store(T *, T);                       \
    void __tsan_atomic##bits##_store(T *at, T value)                \
    {                                                               \
        nap();                                                      \
        __atomic_store_n(at, value, __ATOMIC_SEQ_CST);              \
    }                                                               \
    T __tsan_atomic##bits##_exchange(T *, T);                       \
    T __tsan_atomic##bits##_exchange(T *at, T value)                \
    {                                                               \
        nap();                                                      \
        return __atomic_exchange_n(at, value, __ATOMIC_SEQ_CST);    \
    }                                                               \
    T __tsan_atomic##bits##_compare_exchange_val(T *, T, T);        \
    T __tsan_atomic##bits##_compare_exchange_val(T *at, T expected, \
                                                 T with)            \
    {                                                               \
        __atomic_compare_exchange_n(at, &expected, with, false,     \
                                    __ATOMIC_SEQ_CST,               \
                                    __ATOMIC_SEQ_CST);              \
        return expected;                                            \
    }                                                               \
    FETCH(bits, T, add)                                             \
    FETCH(bits, T, sub)                                             \
    FETCH(bits, T, and)                                             \
    FETCH(bits, T, or)                                              \
    FETCH(bits, T, xor)                                             \
    COMPARE(bits, T, strong)                                        \
    COMPARE(bits, T, weak)

ATOMICS(8, uint8_t)
ATOMICS(16, uint16_t)
ATOMICS(32, uint32_t)
ATOMICS(64, uint64_t)
