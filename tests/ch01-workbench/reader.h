// The tests of reading and writing, run with the workbench's.
#pragma once

void good_tables_are_read(void);
void good_tsplib_files_are_read(void);
void bad_tables_are_refused(void);
void bad_tsplib_files_are_refused(void);
void no_file_at_all_is_refused(void);
void many_points_are_read(void);
void the_first_bad_line_is_named(void);

void numbers_survive(void);
void extreme_numbers_survive(void);
void numbers_are_short(void);
void both_ways_read_alike(void);
