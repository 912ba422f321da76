# chapters/ch01-near.md
# expect: chapters/ch01-near.md:13: the fragment "Answer for one point" is shown twice, here and at chapters/ch01-near.md:6
13s/.*/Answer for one point/
