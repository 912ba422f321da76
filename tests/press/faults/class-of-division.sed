# chapters/ch01-near.md
# expect: chapters/ch01-near.md:33: the class "quik" is unknown for a division
33s/quick/quik/
