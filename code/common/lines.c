// Each line is copied and made plain there: the text stays as it came.
// What was never meant to be read by people, or has no line end in a
// megabyte, is refused and not guessed at.
#include "common/lines.h"
#include "common/allocate.h"
#include "common/fail.h"
#include "common/fields.h"
#include "common/min_max.h"
#include <stdlib.h>
#include <string.h>

// Behind the last line that has an end; or where the text begins.
static const char *last_end(const char *text, size_t length)
{
    while (length > 0 && text[length - 1] != '\n')
        length--;
    return text + length;
}

struct lines lines_of(struct stream *stream)
{
    return (struct lines){.stream = stream,
                          .next = stream->bytes,
                          .end =
                              last_end(stream->bytes, stream->length),
                          .copy = allocate(LONGEST_LINE, 1)};
}

void lines_free(struct lines *lines)
{
    free(lines->copy);
}

//> Say what is wrong with a line
void reject(const struct lines *lines, const char *expected)
{
    enum { longest = 60 }; // a quotation, not the whole file
    fail("%s:%zu: expected %s, found \"%.*s\"%s", lines->stream->name,
         lines->number, expected, longest, lines->line,
         strlen(lines->line) > longest ? "..." : "");
}
//<
// A control character is a sign that this was never meant to be read by
// people.
static bool is_text(const char *line, size_t length)
{
    unsigned char control = 0;
    length -= length > 0 && line[length - 1] == '\n';
    length -= length > 0 && line[length - 1] == '\r';
    for (size_t k = 0; k < length; k++)
        control |= (unsigned char)line[k] < ' ' && line[k] != '\t';
    return !control;
}

// Cuts off a comment, the line's end and the spaces around the rest.
static void trim(struct lines *lines)
{
    char *line = lines->line + strspn(lines->line, " ");
    char *end = strchr(line, '#') ? line + (field_end(line, '#') - line)
                                  : strchr(line, 0);
    while (end > line &&
           (end[-1] == ' ' || end[-1] == '\r' || end[-1] == '\n'))
        end--;
    *end = 0;
    lines->line = line;
}

void blank_tabs(struct lines *lines)
{
    char *tab = strchr(lines->line, '\t');
    for (char *c = tab; c; c = strchr(c, '\t'))
        *c = ' ';
    if (tab)
        trim(lines);
}

// Of the next line, with its end; 0 if there is none.
static size_t line_length(const struct lines *lines)
{
    const size_t rest = lines->end - lines->next;
    const char *newline = memchr(lines->next, '\n', rest);
    return newline ? (size_t)(newline + 1 - lines->next) : rest;
}

bool take_line(struct lines *lines)
{
    do {
        const char *line = lines->next;
        const size_t length = line_length(lines);
        if (length == 0 || length >= LONGEST_LINE - 1 ||
            !is_text(line, length))
            return false;
        lines->next += length;
        lines->number++;
        lines->complete = line[length - 1] == '\n';
        lines->line = memcpy(lines->copy, line, length);
        lines->line[length] = 0;
        if (strncmp(lines->line, "\xef\xbb\xbf", 3) == 0)
            memset(lines->line, ' ', 3); // a byte order mark
        trim(lines);
        if (!lines->tabs)
            blank_tabs(lines);
    } while (!lines->line[strspn(lines->line, " \t")]);
    return true;
}

// Gets more text, up to the last end of a line; at the end of the file,
// or where a line is too long, all there is. False if there is none.
static bool read_text(struct lines *lines)
{
    struct stream *stream = lines->stream;
    size_t came;
    bool ended;
    stream_drop(stream, lines->next - stream->bytes);
    do {
        came = stream_more(stream);
        const char *fresh = stream->bytes + stream->length - came;
        lines->end = last_end(fresh, came);
        ended = lines->end > fresh;
    } while (came > 0 && !ended && stream->length < LONGEST_LINE);
    if (!ended)
        lines->end = stream->bytes + stream->length;
    lines->next = stream->bytes;
    return lines->next < lines->end;
}

// How much of a line that is too long has been read depends on the
// threads; what is said of it does not.
bool next_line(struct lines *lines)
{
    while (!take_line(lines)) {
        const size_t all = line_length(lines);
        const size_t length = MIN(all, LONGEST_LINE - 1);
        if (length > 0)
            fail("%s:%zu: expected text, found a %s",
                 lines->stream->name, lines->number + 1,
                 is_text(lines->next, length) ? "line without end"
                                              : "binary file");
        if (!read_text(lines))
            return false;
    }
    return true;
}
