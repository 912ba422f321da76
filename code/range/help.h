// What range can do, for a user who has not read the book.
#pragma once

// Prints the manual on standard output.
void print_range_help(void);

// Prints the structures and the distributions on standard output.
void print_range_list(void);
