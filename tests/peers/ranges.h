// The tests of chapter 12's contest, run with the other one's.
#pragma once

void wrong_ranges_are_refused(void);
void scipy_answers_rightly(void);
void python_may_be_missing(void);
