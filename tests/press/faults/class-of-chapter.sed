# chapters/appendix-more.md
# expect: chapters/appendix-more.md:1: the class "many" is unknown for a chapter
1s/listings/many/
