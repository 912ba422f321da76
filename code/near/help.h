// What near can do, for a user who has not read the book. It is in this
// one place: `near --help` prints it, and the book what near prints.
#pragma once

// Prints the manual on standard output.
void print_help(void);

// Prints the algorithms and the distributions on standard output.
void print_list(void);
