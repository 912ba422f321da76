// What the figures of the web edition share: the points of a page, the
// question about them and its answers, all of them exported. A page has
// one of each; a function that asks keeps the points that are set.
#pragma once
#include "common/question.h"

// The page calls it by this name; in C it is page_NAME.
#define EXPORT(name) __attribute__((export_name(#name))) page_##name

extern struct question page_question;
extern struct answers page_answers;
extern struct counts page_counts; // of what was asked last

// Forgets what a figure has made of the points. Each figure that makes
// something gives its own way to forget it.
void page_forget_cells(void);
