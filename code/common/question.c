//> Make room for answers
// And for what a search needs besides.
#include "common/question.h"
#include "common/clock.h"
#include "common/fail.h"
#include "common/workspace.h"
#include <stdlib.h>

void search_in_workspace(const struct question *question,
                         search_function *search,
                         struct answers *answers)
{
    struct workspace own = {0};
    struct question mine = *question;
    if (!mine.workspace)
        mine.workspace = &own;
    struct mark mark = workspace_mark(mine.workspace);
    search(&mine, answers);
    workspace_release(mine.workspace, mark);
    workspace_free(&own);
}

void note_built(const struct question *question)
{
    if (question->built_ns)
        *question->built_ns = clock_ns();
}

//> Keep only the answers that will be given
struct answers answers_for(uint32_t n, unsigned given)
{
    struct answers answers = {0};
    if (given & NEAREST) {
        answers.nearest = allocate(n, sizeof *answers.nearest);
        answers.nearest2 = allocate(n, sizeof *answers.nearest2);
    }
    if (given & FURTHEST) {
        answers.furthest = allocate(n, sizeof *answers.furthest);
        answers.furthest2 = allocate(n, sizeof *answers.furthest2);
    }
    return answers;
}
//<

struct answers answers_allocate(uint32_t n)
{
    return answers_for(n, NEAREST | FURTHEST);
}

void answers_free(struct answers *answers)
{
    free(answers->nearest);
    free(answers->furthest);
    free(answers->nearest2);
    free(answers->furthest2);
    *answers = (struct answers){0};
}
//<
