// The bytes of a file, a pipe or standard input, in order, a stretch of
// them at a time. Memory is that of the stretch, however long the file.
#pragma once
#include <stddef.h>
#include <stdint.h>

//> Hold a stretch of a file
struct stream {
    const char *name; // of the file, for messages
    int file;         // its descriptor
    char *bytes;      // a stretch of the file, bytes[0 .. length-1]
    size_t length, room;
};
//<

// Opens the file of this name, or standard input for "-"; fails if it
// cannot. Nothing of it is there yet, and no room. Released with
// stream_close.
struct stream stream_open(const char *name);
void stream_close(struct stream *stream);

// Makes room for so many bytes; called once.
void stream_reserve(struct stream *stream, size_t room);

// Adds what there is at once, if there is room; a pipe is waited for.
// Returns how many bytes came: 0 at the end of the file.
size_t stream_more(struct stream *stream);

// Gives up the first bytes, so many.
void stream_drop(struct stream *stream, size_t used);

// How many bytes the whole file has, or 0 if that cannot be known.
uint64_t stream_size(const struct stream *stream);
