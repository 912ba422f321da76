// A text file, one line at a time, with what a message about it needs:
// the file's name, the line's number and the line itself.
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { LONGEST_LINE = 1 << 20 }; // that was meant to be read

//> Remember where we are in the file
struct lines {
    const char *name; // of the file, for messages
    FILE *file;
    char *line;    // the current one: no comment, no spaces around it
    size_t number; // of the line, from 1
    bool complete; // the line ended in '\n'
    bool tabs;     // tabs are kept; otherwise each becomes a space
};
//<

// Opens the file of this name, or standard input for "-"; fails if it
// cannot. Released with lines_close.
struct lines lines_open(const char *name);
void lines_close(struct lines *lines);

// Goes on to the next line that has more than spaces, tabs and a
// comment, which begins with a '#' outside of double quotes; false at
// the end of the file. Fails where this is no text.
bool next_line(struct lines *lines);

// Makes spaces of the tabs of the current line.
void blank_tabs(struct lines *lines);

// Ends the program: FILE:LINE: expected ..., found "the line".
_Noreturn void reject(const struct lines *lines, const char *expected);
