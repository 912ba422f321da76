// Prints every byte that there is.
// score: 0
// says: lowest indices
#include "right.h"
#include <stdio.h>

struct pair nearest_pair(struct points points)
{
    for (int c = 0; c < 256; c++)
        putchar(c);
    puts(
        "\xed\xa0\x80 \xc0\x80 \xf4\x90\x80\x80 \xef\xbf\xbf \xe2\x82");
    puts("\033[2J\033]0;title\007 \\u0000 \\ud800 ]]> <!-- &amp; \"");
    return points.n > 0 ? wrong() : right(points);
}
