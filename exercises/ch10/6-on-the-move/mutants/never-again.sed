# Puts points once only.
# expect: they have left long ago
# why: The first step is right, and the next ones look right for a while.
s/ || has_strayed(x, cell % box.columns) ||/ \&\& (has_strayed(x, cell % box.columns) || 1 ||/
s/has_strayed(y, cell \/ box.columns))/&)/
