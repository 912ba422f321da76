# chapters/ch01-near.md
# expect: chapters/ch01-near.md:42: the class "cpp" is unknown for a code block
41s/c$/cpp/
