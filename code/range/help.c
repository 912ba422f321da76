// The manual, line by line, and lists made from the tables. Lines of at
// most 63 letters fit any terminal.
#include "range/help.h"
#include "ch12-range-queries/structures.h"
#include "common/generate.h"
#include <stdio.h>

static const char *const manual[] = {
    "range - find points in boxes, within a distance, or nearest",
    "",
    "  range QUESTION [options] FILE   points from FILE ('-':",
    "                                  standard input)",
    "  range QUESTION [options] -n N   N random points",
    "  range --list                    names of structures",
    "  range --help                    this manual",
    "",
    "Points have 1 to 8 coordinates. The answers are exact. It",
    "prints a summary, or with -o writes a table of all answers.",
    "",
    "QUESTION",
    "  --box         which points lie in each box, its borders",
    "                included?",
    "  --within R    which lie within the distance R of each place?",
    "  --nearest K   which K are the nearest to each place? Of",
    "                equally near ones, the lowest numbers",
    "",
    "QUERIES",
    "  --queries F   from the file F: places have a column for each",
    "                coordinate, boxes two: all low ends, then all",
    "                high ends",
    "  --random Q    Q random ones inside the range of the points",
    "  --share S     a random box has sides of S times those of",
    "                the range; 0.1 if it is not said",
    "  Without these, each point asks for its neighbors, itself left",
    "  out, and there are 1000 random boxes.",
    "",
    "POINTS",
    "  FILE          a text file with a point a line, a column for",
    "                each coordinate, separated by semicolons, or",
    "                else commas, or else single tabs, or else",
    "                spaces. What follows a # is a comment; the",
    "                first line may be a header of words",
    "  -n N          N random points",
    "  --dimensions D  with D coordinates, 1 to 8; 3 if it is not",
    "                said",
    "  -d DIST       their distribution, two coordinates at a time",
    "  -s SEED       another seed gives other points and queries",
    "",
    "ANSWERS",
    "  -o FILE       write them to FILE ('-': standard output): a",
    "                row for each point found, QUERY POINT, and the",
    "                DISTANCE but for boxes, numbered from 0",
    "  --counts      a row for each query, QUERY COUNT",
    "  --check       compare them with a plain search",
    "",
    "HOW",
    "  -a NAME       the structure that is built; --list has them",
    "  -t THREADS    so many threads",
    "  -r TRIALS     build and ask so many times",
    "  --timing      one line a trial: times in nanoseconds, bytes,",
    "                and the work of all queries together",
    "",
    "Exit status: 0, or 1 where --check finds a wrong answer, or 2",
    "where something is wrong with the input.",
};

void print_range_help(void)
{
    for (size_t k = 0; k < sizeof manual / sizeof *manual; k++)
        puts(manual[k]);
}

void print_range_list(void)
{
    puts("structures (-a); those with (box) find no neighbors:");
    for (int row = 0; row < structure_count; row++)
        printf("  %-21s %s%s\n", structures[row].name,
               structures[row].about,
               structures[row].neighbors ? "" : " (box)");
    puts("\ndistributions (-d):");
    for (int row = 0; row < distribution_count; row++)
        printf("  %-21s %s\n", distributions[row].name,
               distributions[row].about);
}
