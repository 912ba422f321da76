// The stream of common/stream.h, from memory: the page's text in place
// of a file.
#include "web/text.h"
#include "common/allocate.h"
#include "common/stream.h"
#include <stdlib.h>
#include <string.h>

static char *text;
static size_t length, taken;

char *text_room(uint32_t bytes)
{
    free(text);
    text = allocate((size_t)bytes + 1, 1);
    text[bytes] = '\0';
    length = bytes;
    return text;
}

struct stream stream_open(const char *name)
{
    taken = 0;
    return (struct stream){.name = name};
}

void stream_close(struct stream *stream)
{
    free(stream->bytes);
}

void stream_reserve(struct stream *stream, size_t room)
{
    stream->room = room;
    stream->bytes = allocate(room, 1);
}

size_t stream_more(struct stream *stream)
{
    size_t free_room = stream->room - stream->length;
    size_t left = length - taken;
    size_t more = left < free_room ? left : free_room;
    memcpy(stream->bytes + stream->length, text + taken, more);
    stream->length += more;
    taken += more;
    return more;
}

void stream_drop(struct stream *stream, size_t used)
{
    stream->length -= used;
    memmove(stream->bytes, stream->bytes + used, stream->length);
}

uint64_t stream_size(const struct stream *stream)
{
    (void)stream;
    return length;
}
