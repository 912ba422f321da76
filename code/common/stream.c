// One read of the system for each stretch: of a file it fills the room,
// of a pipe it takes what has been written, so that a line is looked at
// as soon as it is there.
#include "common/stream.h"
#include "common/allocate.h"
#include "common/fail.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct stream stream_open(const char *name)
{
    struct stream stream = {.name = name};
    if (strcmp(name, "-") == 0) {
        stream.name = "standard input";
        stream.file = STDIN_FILENO;
    } else if ((stream.file = open(name, O_RDONLY | O_CLOEXEC)) < 0) {
        fail("cannot open %s: %s", name, strerror(errno));
    }
    return stream;
}

void stream_close(struct stream *stream)
{
    free(stream->bytes);
    if (stream->file != STDIN_FILENO)
        close(stream->file);
}

void stream_reserve(struct stream *stream, size_t room)
{
    stream->room = room;
    stream->bytes = allocate(room, 1);
}

size_t stream_more(struct stream *stream)
{
    ssize_t came;
    do
        came = read(stream->file, stream->bytes + stream->length,
                    stream->room - stream->length);
    while (came < 0 && errno == EINTR);
    if (came < 0)
        fail("cannot read %s: %s", stream->name, strerror(errno));
    stream->length += came;
    return came;
}

void stream_drop(struct stream *stream, size_t used)
{
    stream->length -= used;
    memmove(stream->bytes, stream->bytes + used, stream->length);
}

uint64_t stream_size(const struct stream *stream)
{
    struct stat file;
    return fstat(stream->file, &file) == 0 && S_ISREG(file.st_mode)
               ? file.st_size
               : 0;
}
