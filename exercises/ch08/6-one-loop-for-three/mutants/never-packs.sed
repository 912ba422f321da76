# Never packs.
# expect: goes on and on
# why: Finished lanes are skipped, and nothing ever ends.
s/kept += lanes->place\[l\] < lanes->end\[l\]/kept++/
