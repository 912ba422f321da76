// A wrong answer that --check finds: status 1, a sentence, and no file.
// No algorithm of the table gives one, so here the check says that it
// found one.
#define check_answers find_a_mistake
#define main near_main
#include "near/near.c"
#undef main
#include "harness.h"
#include "status.h"
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

struct verdicts find_a_mistake(const struct question *question,
                               const struct answers *answers)
{
    (void)question;
    (void)answers;
    return (struct verdicts){.nearest = {.wrong = 2, .first = 3}};
}

void a_mistake_has_status_1(void)
{
    char file[] = "/tmp/near-status-XXXXXX";
    close(mkstemp(file));
    FILE *said = tmpfile();
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        dup2(fileno(said), STDOUT_FILENO);
        setenv("OMP_WAIT_POLICY", "passive", 1); // or near starts anew
        char *arguments[] = {"near", "-n", "10", "--check", "-t",
                             "1",    "-o", file, NULL};
        int status = near_main(8, arguments);
        fflush(stdout);
        _exit(status);
    }
    int status = 0;
    waitpid(child, &status, 0);
    CHECK_INT(1, WIFEXITED(status) ? WEXITSTATUS(status) : -1,
              "the status");

    char text[100] = "";
    rewind(said);
    text[fread(text, 1, sizeof text - 1, said)] = 0;
    fclose(said);
    *(strchr(text, '\n') ? strchr(text, '\n') : text) = 0;
    CHECK_TEXT("check: 2 of 10 nearest neighbors are wrong, the first "
               "that of point 3",
               text, "the sentence");

    FILE *answers = fopen(file, "r");
    CHECK(answers && fgetc(answers) == EOF, "the file is as it was");
    if (answers)
        fclose(answers);
    unlink(file);
}
