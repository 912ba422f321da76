# Every array begins a page.
# expect: at most
# why: A page is what the chapter talks about.
s/ALIGNED = 64/ALIGNED = 4096/
