// The manual, line by line, and lists made from the tables. Lines of at
// most 63 letters fit any terminal.
#include "near/help.h"
#include "algorithms.h"
#include "common/generate.h"
#include <stdio.h>

static const char *const manual[] = {
    "near - find every point's nearest and furthest neighbor",
    "",
    "  near [options] FILE   points from FILE ('-': standard input)",
    "  near [options] -n N   N random points",
    "  near --list           names of algorithms and distributions",
    "  near --help           this manual",
    "",
    "For each point of a plane, near finds which other point is the",
    "nearest and which is the furthest, and the distances to both.",
    "The answers are exact. It prints a summary, or with -o writes a",
    "table of all answers.",

    "",
    "EXAMPLES",
    "  near cities.csv -o neighbors.tsv",
    "      read cities.csv, write all answers to neighbors.tsv",
    "  near cities.csv -k 8 -o eight.tsv",
    "      the eight nearest of each city, a line for each of them",
    "  near cities.csv --columns 2,3 -o -",
    "      x and y in columns 2 and 3, answers to standard output",
    "  near -n 20000 -d clustered --check",
    "      random points, all answers compared with a plain search",
    "  near sky.txt -g wraparound --box 0,0,360,180",
    "      a box whose left side meets its right, its top its bottom",
    "  near -n 1e5 -a row-spans -t 1 -r 5 --timing",
    "      only the nearest, by one thread, timed five times",

    "",
    "POINTS",
    "  FILE          a text file with a point a line: two numbers,",
    "                with semicolons between them, or else commas,",
    "                or else single tabs, or else spaces, however",
    "                many: as in the first line. What follows a #",
    "                is a comment, what is in double quotes is one",
    "                field, empty lines do not count, and the first",
    "                line may be a header of words:",
    "",
    "                    name,x,y       # wants --columns 2,3",
    "                    harbor,12.5,7",
    "                    mill,3,-0.25",
    "",
    "                All lines have as many fields as the first.",
    "                A file whose first line is KEYWORD: VALUE is",
    "                taken for a TSPLIB file of points in a plane,",
    "                and one that begins as NumPy's .npy files do",
    "                for an array of doubles ('<f8') with two",
    "                columns and a row for each point. There must be",
    "                2 points at least and 4294967295 at most, all",
    "                finite. Points may coincide. A number too small",
    "                for a double is refused.",
    "  --columns I,J the columns of FILE that hold x and y, counted",
    "                from 1; needed if there are more than two",
    "  -n N          draw N random points, 2 to 4294967295; 1e5 is",
    "                a number, too",
    "  -d DIST       their distribution; --list has the names",
    "                (default: uniform, in a square of side 1)",
    "  -s SEED       0 to 2^64 - 1: other points for another seed,",
    "                the same for the same (default: 1)",

    "",
    "QUESTION",
    "  -g GEOMETRY   standard or wraparound (default: standard); see",
    "                GEOMETRIES",
    "  --box X0,Y0,X1,Y1",
    "                the box that wraps around; it must hold all",
    "                points (default: 0,0,1,1)",
    "  -k K          instead, the K nearest neighbors of each point",
    "  --within R    instead, all that are no further away than R",
    "  --counts      with --within: only how many these are",
    "  -a NAME       an algorithm; --list has the names (default:",
    "                the fastest for the nearest and the fastest for",
    "                the furthest, or one for both); see ALGORITHMS",
    "  -t THREADS    use so many threads at most, 1 to 1024; the",
    "                answers are the same (default: OMP_NUM_THREADS,",
    "                or else the number of processors; but no more",
    "                than one for every 2000 points)",
    "  -r TRIALS     answer so many times, 1 to 1000000; the summary",
    "                then has the median time (default: 1)",

    "",
    "ANSWER",
    "  -o FILE       write all answers to FILE ('-': standard",
    "                output) instead of a summary, and to FILE.npy",
    "                as an array of NumPy's; see TABLES",
    "  --timing      print a table of times instead of a summary",
    "  --check       compare all answers with those of a plain",
    "                search through every pair, and say how many are",
    "                wrong; it takes four times as long for twice",
    "                the points",
    "  --list        only print the algorithms, with what they",
    "                answer, and the distributions",
    "  --help        only print this manual",

    "",
    "TABLES",
    "Tabs separate the columns, and the first line names them. With",
    "-o there is a line for each point, in the order of the file:",
    "",
    "  i                  the point's number, from 0",
    "  x, y               its coordinates",
    "  nearest            the number of its nearest neighbor",
    "  nearest_distance   the distance to it, in the unit of x and y",
    "  furthest           the number of its furthest neighbor",
    "  furthest_distance  the distance to it",
    "",
    "What the algorithm does not answer is left out. A point is",
    "never its own neighbor, but another in the same place is, at",
    "distance 0. If several are equally far, the one with the lowest",
    "number is named. Numbers have the fewest digits that read back",
    "as the same double. The file gets its name when it is complete",
    "and on the disk, not before.",
    "",
    "With -k or --within there is a line for each neighbor of each",
    "point, the nearest first: i, neighbor, distance; where there",
    "are fewer than K others, all of them. With --counts there is a",
    "line for each point: i, count.",
    "",
    "An .npy file holds the same, a record for each line, whose",
    "fields have the names of the columns: in Python,",
    "numpy.load('FILE.npy')['nearest']. It is read and written in a",
    "small part of the time.",
    "",
    "With --timing there is a line for each trial:",
    "",
    "  algorithm          its name",
    "  n, threads         how many points, and threads at most",
    "  build_ns           nanoseconds to put the points in order, or",
    "                     0 if the algorithm has no such part",
    "  query_ns           nanoseconds for the rest",
    "  total_ns           the sum of both",
    "  distances          how many distances it computes, counted in",
    "                     a run of its own",

    "",
    "GEOMETRIES",
    "standard: along a straight line.",
    "",
    "wraparound: every point has images a width or a height of the",
    "box away, as in a simulation of a space without a border. The",
    "nearest neighbor is measured to its closest image: along each",
    "axis, the smaller of d and side - d counts, where d is how far",
    "apart the coordinates are. The furthest neighbor is measured to",
    "the furthest of the images around: along each axis, the larger",
    "of d and side - d counts. The first is the distance on a torus.",
    "The second is not: what is furthest on a torus is the point",
    "whose closest image is furthest away, and near does not search",
    "for that.",

    "",
    "ALGORITHMS",
    "All are exact. Without -a, near takes the fastest; name another",
    "to compare it, or to leave out an answer that you do not need.",
    "In the list, 'ch' is the chapter of the book that explains it,",
    "'geometry' and 'answers' say what it knows, and 'cost' how its",
    "time grows with the number n of points. What costs n^2 looks at",
    "pairs: twice the points, four times the time, however they lie.",
    "What costs n, or n log n, takes little more than twice the time",
    "for twice the points. Rows of one grid slow down if the points",
    "crowd in a few of its cells. So without -a, near looks at a",
    "sample first: where points crowd it takes adaptive, which cuts",
    "the plane into pieces; --timing says which row it took.",

    "",
    "MEMORY AND TIME",
    "All points are held in memory. Count on 120 bytes for each, and",
    "on a few million for each thread. If the points are spread",
    "evenly, to read them from a file or to write the answers takes",
    "longer than to find them. While work is long and standard error",
    "is a terminal, a line there says for how long it has been going",
    "on.",

    "",
    "ENVIRONMENT",
    "  NEAR_ISA      the instructions to use: portable, avx2 or",
    "                avx512 (default: the best that the processor",
    "                has)",
    "  OMP_NUM_THREADS",
    "                how many threads to use if -t does not say",
    "  OMP_WAIT_POLICY",
    "                active: threads that wait for each other keep",
    "                their processors busy; a little faster where",
    "                no other work is going on (default: passive;",
    "                they look for work GOMP_SPINCOUNT times, 1000",
    "                or some 25 microseconds, and then sleep)",

    "",
    "EXIT STATUS",
    "  0             done; a check, if asked for, found no mistake",
    "  1             --check found wrong answers, which is a mistake",
    "                of near's; no table of answers is written",
    "  2             near cannot do what is asked. A sentence on",
    "                standard error says why, and no file is written",
    "                or changed:",
    "",
    "                    near: cities.csv:17: expected two numbers,",
    "                    found \"12.5,abc\"",
    "",
    "A run that is interrupted leaves no file either. A warning says",
    "if squares of distances leave the range of a double: points",
    "more than about 1e154 apart then count as infinitely far, and",
    "those within 1e-154 or so of each other as equal. Scale the",
    "coordinates.",
};

void print_help(void)
{
    for (size_t k = 0; k < sizeof manual / sizeof *manual; k++)
        puts(manual[k]);
}

static const char *names_of_geometries(unsigned set)
{
    return set == STANDARD     ? "standard"
           : set == WRAPAROUND ? "wraparound"
                               : "both";
}

static const char *names_of_answers(unsigned set)
{
    return set == NEAREST    ? "nearest"
           : set == FURTHEST ? "furthest"
                             : "both";
}

void print_list(void)
{
    printf("%-18s %2s %-10s %-8s %-5s %s\n", "algorithm", "ch",
           "geometry", "answers", "cost", "what it does");
    for (int row = 0; row < algorithm_count; row++) {
        const struct algorithm *a = &algorithms[row];
        printf("%-18s %2d %-10s %-8s %-5s %s\n", a->name, a->chapter,
               names_of_geometries(a->geometries),
               names_of_answers(a->answers), a->cost, a->about);
    }
    printf("\n%s\n", "distribution");
    for (int row = 0; row < distribution_count; row++)
        printf("%-18s %s\n", distributions[row].name,
               distributions[row].about);
}
