# Does not count the cells.
# expect: has visited one more
/lanes->visited\[lane\]++/d
