# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: references.bib has no entry "somebody"
20s/by=coursework/by=somebody/
