# Goes one place beyond the cell.
# expect: just behind a cell
# why: The end is the first place that is not the cell's, and they take it for the last that is.
s/lanes->place\[l\] == lanes->end\[l\]/lanes->place[l] > lanes->end[l]/
s/lanes.end\[l\] = 0;/lanes.end[l] = 0, lanes.place[l] = 1;/
s/kept += lanes->place\[l\] </kept += lanes->place[l] <=/
