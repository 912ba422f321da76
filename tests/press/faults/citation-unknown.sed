# chapters/ch01-near.md
# expect: chapters/ch01-near.md:9: references.bib has no entry "bentley1981"
9s/bentley1980/bentley1981/
