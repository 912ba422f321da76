// What contact can do, for a user who has not read the book.
#pragma once

// Prints the manual on standard output.
void print_contact_help(void);

// Prints the scenes and the broad phases on standard output.
void print_contact_list(void);
