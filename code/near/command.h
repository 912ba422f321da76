// What the command lines of near, range and contact have in common:
// options are taken one after the other, and what none of them knows is
// refused in a sentence.
#pragma once
#include <getopt.h>

struct command {
    const char *program;        // as it is called in sentences
    const char *letters;        // of options, as for getopt
    const struct option *names; // as for getopt_long; flags set an int
    void (*take)(void *options, int option); // the value is in optarg
};

// Has all options taken; returns the one FILE, or NULL. Fails with a
// sentence on options that there are not, values that are missing, and
// a second file.
const char *take_options(const struct command *command, int argc,
                         char **argv, void *options);
