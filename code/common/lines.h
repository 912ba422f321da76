// A text file, one line at a time, with what a message about it needs:
// the file's name, the line's number and the line itself.
#pragma once
#include "common/stream.h"
#include <stdbool.h>

// That was meant to be read. (tests/fuzz.c makes it short.)
#ifndef LONGEST_LINE
#define LONGEST_LINE (1 << 20)
#endif

//> Remember where we are in the file
struct lines {
    struct stream *stream;  // where the text comes from
    const char *next, *end; // the text that is there and not yet taken
    char *line;    // the current one: no comment, no spaces around it
    size_t number; // of the line, from 1
    bool complete; // the line ended in '\n'
    bool tabs;     // tabs are kept; otherwise each becomes a space
    char *copy;    // holds the line
};
//<

// Lines from the stream, none taken. Released with lines_free, the
// stream by its owner.
struct lines lines_of(struct stream *stream);
void lines_free(struct lines *lines);

// Goes on to the next line that has more than spaces, tabs and a
// comment, which begins with a '#' outside of double quotes; false at
// the end of the file. Fails where this is no text.
bool next_line(struct lines *lines);

// The same for the text that is there already; false, too, before what
// is no text.
bool take_line(struct lines *lines);

// Makes spaces of the tabs of the current line.
void blank_tabs(struct lines *lines);

// Ends the program: FILE:LINE: expected ..., found "the line".
_Noreturn void reject(const struct lines *lines, const char *expected);
