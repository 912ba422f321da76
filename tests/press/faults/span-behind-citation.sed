# chapters/ch01-near.md
# expect: chapters/ch01-near.md:9: this is printed as it stands: "][]{.index"
9s/\[@bentley1980\]/[@bentley1980][]{.index key="box"}/
