# Puts points elsewhere as soon as they have left their cell.
# expect: must not be put to
# why: That cells are exact was the rule in all chapters before.
s/k - margin || x > k + 1 + margin/k || x >= k + 1/
