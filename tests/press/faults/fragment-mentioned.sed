# chapters/ch01-near.md
# expect: chapters/ch01-near.md:3: no chapter shows the fragment "Try it", which is mentioned here
3s/$/ See [Try it]{.fragment}./
