// The reader's tests, run with the workbench's.
#pragma once

void good_tables_are_read(void);
void good_tsplib_files_are_read(void);
void bad_tables_are_refused(void);
void bad_tsplib_files_are_refused(void);
void no_file_at_all_is_refused(void);
void many_points_are_read(void);
