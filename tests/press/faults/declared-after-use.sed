# chapters/ch01-near.md
# expect: chapters/ch01-near.md:83: "next" is read here (code/ch01-near/span.h:13), and struct span (code/ch01-near/span.h:2) has not been printed yet
/^Say what a span is$/{N;s/\(.*\)\n\(.*\)/\2\n\1/;}
