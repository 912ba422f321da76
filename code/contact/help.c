// The manual, line by line, and lists made from the tables. Lines of at
// most 63 letters fit any terminal.
#include "contact/help.h"
#include "ch13-contact/broad_phase.h"
#include "ch13-contact/scenes.h"
#include <stdio.h>

static const char *const manual[] = {
    "contact - find contacts between moving bodies of triangles",
    "",
    "  contact [options] FILE          the scene in FILE ('-':",
    "                                  standard input)",
    "  contact --scene NAME [options]  a scene of the list",
    "  contact --list                  scenes and broad phases",
    "  contact --help                  this manual",
    "",
    "Nodes move along straight lines in each step. No contact is",
    "missed; a body that would touch another one stays where it",
    "is, and impulses keep the two apart. It prints a summary, or",
    "with -o writes a table.",
    "",
    "SCENE",
    "  FILE          a text file with a body a line: its shape, and",
    "                then in any order where and how it is:",
    "                  sphere CUTS        20 4^CUTS triangles",
    "                  torus TUBE N M     2 N M triangles",
    "                  box CUTS           12 CUTS^2 triangles",
    "                  cloth CUTS         2 CUTS^2 triangles",
    "                  file NAME          .off, .obj or .stl",
    "                  at X Y Z           its place; usually 0 0 0",
    "                  size S             so much larger",
    "                  velocity X Y Z",
    "                  spin X Y Z         radians in a time of 1",
    "                  fixed              it stays",
    "                  soft               each node on its own",
    "                A line 'gravity X Y Z' is no body. What follows",
    "                a # is a comment. A sphere has radius 1, boxes",
    "                and cloths sides of 2, a torus middle line has",
    "                radius 1",
    "  -n SIZE       of a scene of the list: how many bodies, or",
    "                squares a side",
    "  -s SEED       another seed gives another scene",
    "",
    "STEPS",
    "  --steps N     so many; 100 if it is not said",
    "  --dt DT       the time of a step",
    "  --tolerance T what is no further apart may count as touching;",
    "                1e-9 if it is not said. Bodies that are nearer",
    "                than some 1e-13 of their size cannot be told",
    "                from bodies that touch, and stay where they are",
    "  --passive     only find contacts: nothing is kept apart.",
    "                Without it, triangles of two bodies that cross",
    "                or touch at the beginning are refused",
    "  -a NAME       the broad phase; --list has them",
    "  -t THREADS    so many threads",
    "  --check       compare with all pairs, and see to it that",
    "                nothing crosses after a step",
    "",
    "ANSWERS",
    "  -o FILE       write a table to FILE ('-': standard output), a",
    "                row a step: what was looked at and found, and",
    "                the time of each phase in nanoseconds",
    "  --events      the table has a row for each contact instead:",
    "                a node and a face, or two edges, by the numbers",
    "                of their nodes; when, 0 to 1, and where",
    "  --pictures DIR  write data for pictures into the folder DIR,",
    "                and pictures.gp, a script for gnuplot",
    "",
    "Exit status: 0, or 1 where --check finds something wrong, or 2",
    "where something is wrong with the input.",
};

void print_contact_help(void)
{
    for (size_t k = 0; k < sizeof manual / sizeof *manual; k++)
        puts(manual[k]);
}

void print_contact_list(void)
{
    puts("scenes (--scene):");
    for (int row = 0; row < built_in_count; row++)
        printf("  %-16s %s (-n %u)\n", built_ins[row].name,
               built_ins[row].about, built_ins[row].usual);
    puts("\nbroad phases (-a):");
    for (int row = 0; row < broad_phase_count; row++)
        printf("  %-16s %s\n", broad_phases[row].name,
               broad_phases[row].about);
}
