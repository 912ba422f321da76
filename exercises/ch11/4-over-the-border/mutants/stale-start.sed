# The start goes back to 0 for no point: it does not move.
# expect: and was not measured
# why: The loop that moves it looks like a detail.
s/        while (at < rights/        while (0 \&\& at < rights/;s/        while (at < lefts/        while (0 \&\& at < lefts/
