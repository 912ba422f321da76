# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: a claim needs its condition
20s/.claim if="10[^}]*}/.claim}/
