# Every array begins a page.
# expect: begin a page of its own
# why: A page is what the chapter talks about.
s/ALIGNED = 64/ALIGNED = 4096/
