# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: this is printed as it stands: "t = [3.2]{.given}"
20s/\$t = 3\.2\$/$t = [3.2]{.given}$/
