# All is touched beforehand.
# expect: Pages are touched that nobody needed
# why: The chapter touches fresh blocks at once, with all threads; it knows how much it needs.
s/memory = fresh(MOST);/memory = memset(fresh(MOST), 0, MOST);/
