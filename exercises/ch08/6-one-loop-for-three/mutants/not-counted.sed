# Does not count the cells.
# expect: has visited one more
# why: The number of cells visited is advanced where a lane waits, or where it goes on, or in neither.
/lanes->visited\[lane\]++/d
