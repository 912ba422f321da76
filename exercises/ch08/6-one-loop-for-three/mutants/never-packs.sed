# Never packs.
# expect: goes on and on
s/kept += lanes->place\[l\] < lanes->end\[l\]/kept++/
