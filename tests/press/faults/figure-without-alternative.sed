# book/figures/ch01-speed.gp
# expect: book/figures/ch01-speed.gp:1: this has no text alternative: "# alt: ..."
/alt:/,/first/d
