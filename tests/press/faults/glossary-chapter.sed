# book/glossary.md
# expect: book/glossary.md:4: there is no chapter "ch02"
4s/ch01/ch02/
