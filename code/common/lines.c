// One character after the other into one buffer, and a null character
// behind it: what was never meant to be read by people, or has no line
// end in a megabyte, is refused and not guessed at.
#include "common/lines.h"
#include "common/allocate.h"
#include "common/fail.h"
#include "common/fields.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

struct lines lines_open(const char *name)
{
    bool from_stdin = strcmp(name, "-") == 0;
    struct lines lines = {.name = from_stdin ? "standard input" : name,
                          .file =
                              from_stdin ? stdin : fopen(name, "r")};
    if (!lines.file)
        fail("cannot open %s: %s", name, strerror(errno));
    lines.line = allocate(LONGEST_LINE, 1);
    return lines;
}

void lines_close(struct lines *lines)
{
    free(lines->line);
    if (lines->file != stdin)
        fclose(lines->file);
}
//> Say what is wrong with a line
void reject(const struct lines *lines, const char *expected)
{
    enum { longest = 60 }; // a quotation, not the whole file
    fail("%s:%zu: expected %s, found \"%.*s\"%s", lines->name,
         lines->number, expected, longest, lines->line,
         strlen(lines->line) > longest ? "..." : "");
}
//<
// A control character is a sign that this was never meant to be read by
// people.
static bool is_text(const char *line, size_t length)
{
    for (const char *c = line; c < line + length; c++)
        if ((unsigned char)*c < ' ' && *c != '\t' && *c != '\n' &&
            !(*c == '\r' && (c[1] == '\n' || c[1] == 0)))
            return false;
    return true;
}
// The length of the next line with its end; 0 at the end of the file.
// A null character ends it too: what follows one is no text.
static size_t read_line(struct lines *lines)
{
    size_t length = 0;
    int c = ' ';
    while (c && c != '\n' && length < LONGEST_LINE - 1 &&
           (c = getc_unlocked(lines->file)) != EOF)
        lines->line[length++] = (char)c;
    lines->line[length] = 0;
    return length;
}

// Cuts off a comment, the line's end and the spaces around the rest.
static void trim(char *line)
{
    char *start = line + strspn(line, " ");
    char *end = start + (field_end(start, '#') - start);
    while (end > start && strchr(" \r\n", end[-1]))
        end--;
    memmove(line, start, end - start);
    line[end - start] = 0;
}

void blank_tabs(struct lines *lines)
{
    for (char *c = lines->line; (c = strchr(c, '\t')); c++)
        *c = ' ';
    trim(lines->line);
}

bool next_line(struct lines *lines)
{
    do {
        size_t length = read_line(lines);
        if (ferror(lines->file))
            fail("cannot read %s: %s", lines->name, strerror(errno));
        if (length == 0)
            return false;
        lines->number++;
        if (length == LONGEST_LINE - 1)
            fail("%s:%zu: expected text, found a line without end",
                 lines->name, lines->number);
        lines->complete = lines->line[length - 1] == '\n';
        if (!is_text(lines->line, length))
            fail("%s:%zu: expected text, found a binary file",
                 lines->name, lines->number);
        if (strncmp(lines->line, "\xef\xbb\xbf", 3) == 0)
            memset(lines->line, ' ', 3); // a byte order mark
        trim(lines->line);
        if (!lines->tabs)
            blank_tabs(lines);
    } while (!lines->line[strspn(lines->line, " \t")]);
    return true;
}
