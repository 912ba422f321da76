# chapters/ch01-near.md
# expect: chapters/ch01-near.md:61: "echo 'near: what is this?' >&2; exit 2" ended with status 2, not 0
61s/ status=2//
