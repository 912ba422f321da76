//> Declare the manual
// What near can do, for somebody who has not read the book. It is in
// this one place: `near --help` prints it, and the book what near
// prints.
#pragma once

// Prints the manual on standard output.
void print_help(void);
//<
