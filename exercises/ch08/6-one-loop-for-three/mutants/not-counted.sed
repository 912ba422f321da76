# Does not count the cells.
# expect: has visited one more
# why: The number of cells visited is advanced in the asking, or in the moving on, or in neither.
/lanes->visited\[lane\]++/d
