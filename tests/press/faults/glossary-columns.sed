# book/glossary.md
# expect: book/glossary.md:3: a line of the glossary is "term | definition | synonyms | chNN"
3s/ | | / | /
