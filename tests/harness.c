// See harness.h. CUnit runs the tests and keeps the failures; what we
// add are messages that say enough, wall time, and a report in XML
// that the graders of this world can read.
#include "harness.h"
#include "common/clock.h"
#include "common/fail.h"
#include <CUnit/CUnit.h>
#include <CUnit/TestRun.h>
#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { shown_failures = 5, message_size = 2000 };

static uint64_t seed;
static bool has_seed;

uint32_t at_most(const char *variable, uint32_t count)
{
    const char *limit = getenv(variable);
    uint32_t most = limit ? (uint32_t)atoi(limit) : count;
    return most < count ? most : count;
}

void test_seed(uint64_t value)
{
    seed = value;
    has_seed = true;
}

// Tells CUnit of one check. Only a failure needs its message.
// A check that holds costs little: there are millions.
static bool passed(const char *file, int line)
{
    CU_assertImplementation(CU_TRUE, line, "", file, "", CU_FALSE);
    return true;
}

static bool failed(const char *file, int line, const char *found,
                   const char *what, va_list names)
{
    char message[message_size] = "";
    vsnprintf(message, sizeof message / 2, what, names);
    size_t used = strlen(message);
    used +=
        snprintf(message + used, sizeof message - used, ": %s", found);
    if (has_seed && used < sizeof message)
        snprintf(message + used, sizeof message - used,
                 " (seed %" PRIu64 ")", seed);
    CU_assertImplementation(CU_FALSE, line, message, file, "",
                            CU_FALSE);
    return false;
}

bool check_true(const char *file, int line, const char *condition,
                bool found, const char *what, ...)
{
    if (found)
        return passed(file, line);
    char text[message_size / 2];
    snprintf(text, sizeof text, "expected %s", condition);
    va_list names;
    va_start(names, what);
    failed(file, line, text, what, names);
    va_end(names);
    return false;
}

bool check_int(const char *file, int line, long long expected,
               long long found, const char *what, ...)
{
    if (expected == found)
        return passed(file, line);
    char text[80];
    snprintf(text, sizeof text, "expected %lld, found %lld", expected,
             found);
    va_list names;
    va_start(names, what);
    failed(file, line, text, what, names);
    va_end(names);
    return false;
}

bool check_near(const char *file, int line, double expected,
                double found, double tolerance, const char *what, ...)
{
    if (expected == found || fabs(found - expected) <= tolerance)
        return passed(file, line);
    char text[160];
    int used = snprintf(text, sizeof text,
                        "expected %.17g, found %.17g", expected, found);
    if (tolerance > 0)
        snprintf(text + used, sizeof text - used,
                 ", more than %.3g away", tolerance);
    va_list names;
    va_start(names, what);
    failed(file, line, text, what, names);
    va_end(names);
    return false;
}

bool check_text(const char *file, int line, const char *expected,
                const char *found, const char *what, ...)
{
    if (strcmp(expected, found) == 0)
        return passed(file, line);
    char text[message_size / 2];
    snprintf(text, sizeof text, "expected \"%s\", found \"%s\"",
             expected, found);
    va_list names;
    va_start(names, what);
    failed(file, line, text, what, names);
    va_end(names);
    return false;
}

// Runs work in a child; its stderr and wait status come back.
static int run_apart(void (*work)(void *), void *context, char *said,
                     size_t size)
{
    int ends[2], status;
    fflush(NULL);
    if (pipe(ends) != 0)
        fail("no pipe: %s", strerror(errno));
    pid_t child = fork();
    if (child < 0)
        fail("no process: %s", strerror(errno));
    if (child == 0) {
        close(ends[0]);
        dup2(ends[1], STDERR_FILENO);
        fail_as("test");
        work(context);
        _exit(0);
    }
    close(ends[1]);
    size_t used = 0;
    ssize_t got;
    while ((got = read(ends[0], said + used, size - 1 - used)) > 0)
        used += got;
    said[used] = 0;
    close(ends[0]);
    waitpid(child, &status, 0);
    return status;
}

bool check_fails(const char *file, int line, const char *sentence,
                 void (*work)(void *), void *context, const char *what,
                 ...)
{
    char said[400], text[message_size / 2];
    int status = run_apart(work, context, said, sizeof said);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 2 &&
        strstr(said, sentence))
        return passed(file, line);
    snprintf(text, sizeof text,
             "expected \"%s\" and status 2, found \"%s\" and %s %d",
             sentence, said, WIFEXITED(status) ? "status" : "signal",
             WIFEXITED(status) ? WEXITSTATUS(status)
                               : WTERMSIG(status));
    va_list names;
    va_start(names, what);
    failed(file, line, text, what, names);
    va_end(names);
    return false;
}

// ---- running and reporting -----------------------------------------
static FILE *xml;
static int64_t started;
static int failed_tests;

static void before(const CU_pTest test, const CU_pSuite suite)
{
    (void)test, (void)suite;
    has_seed = false;
    started = clock_ns();
}

static void write_xml_text(const char *text)
{
    for (; *text; text++)
        if (strchr("<>&\"'", *text))
            fprintf(xml, "&#%d;", *text);
        else if ((unsigned char)*text >= ' ')
            fputc(*text, xml);
        else
            fputc(' ', xml);
}

static void after(const CU_pTest test, const CU_pSuite suite,
                  const CU_pFailureRecord failures)
{
    double seconds = 1e-9 * (clock_ns() - started);
    int count = 0;
    fprintf(xml, "<testcase classname=\"%s\" name=\"%s\" time=\"%.3f\"",
            suite->pName, test->pName, seconds);
    for (CU_pFailureRecord f = failures; f; f = f->pNext) {
        if (++count > shown_failures)
            continue;
        fprintf(xml, count == 1 ? "><failure>" : "&#10;");
        write_xml_text(f->strCondition);
        printf("%s:%u: %s: %s\n", f->strFileName, f->uiLineNumber,
               test->pName, f->strCondition);
    }
    if (count > shown_failures)
        printf("%s: and %d more\n", test->pName,
               count - shown_failures);
    failed_tests += count > 0;
    fprintf(xml, count ? "</failure></testcase>\n" : "/>\n");
    fflush(NULL); // so that a crash in the next test loses nothing
}

// The report opens with the outcome, so it can only be put together at
// the end; until then it stands in the temporary file xml.
static void write_report(const char *folder, int n)
{
    const char *build = getenv("BUILD");
    char path[4096];
    build = build ? build : "build";
    mkdir(build, 0777);
    snprintf(path, sizeof path, "%s/tests", build);
    mkdir(path, 0777);
    snprintf(path, sizeof path, "%s/tests/%s.xml", build, folder);
    FILE *report = fopen(path, "w");
    if (!report)
        fail("cannot write %s: %s", path, strerror(errno));
    fprintf(report,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuite name=\"%s\" tests=\"%d\" failures=\"%d\">\n",
            folder, n, failed_tests);
    rewind(xml);
    for (int c; (c = fgetc(xml)) != EOF;)
        fputc(c, report);
    fprintf(report, "</testsuite>\n");
    fclose(report);
    fclose(xml);
}

int run_tests(const char *folder, const struct test *tests, int n)
{
    fail_as(folder);
    if (!(xml = tmpfile()) || CU_initialize_registry() != CUE_SUCCESS)
        fail("cannot start the tests");
    CU_pSuite suite = CU_add_suite(folder, NULL, NULL);
    for (int i = 0; i < n; i++)
        if (!CU_add_test(suite, tests[i].name, tests[i].run))
            fail("cannot add %s: %s", tests[i].name,
                 CU_get_error_msg());
    CU_set_test_start_handler(before);
    CU_set_test_complete_handler(after);
    CU_run_all_tests();
    int ran = CU_get_number_of_tests_run();
    int failures = CU_get_number_of_failure_records();
    CU_cleanup_registry();
    if (ran != n)
        printf("only %d of %d tests ran\n", ran, n);
    write_report(folder, n);
    printf("%d passed, %d failed\n", ran - failed_tests,
           failed_tests + n - ran);
    return failures > 0 || ran != n || n == 0;
}
