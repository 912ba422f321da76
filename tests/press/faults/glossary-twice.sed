# book/glossary.md
# expect: book/glossary.md:4: the glossary explains "Cell" twice, here and in line 1
4s/^grid/Cell/
