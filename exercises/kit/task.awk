# The task of an exercise, from its exercise.md: without front matter,
# hints, and what is for instructors. Tables keep what is in them.
/^---$/ && ++rules <= 2 { next }
rules < 2 { next }
/^:::+ *[^: ]/ {
    depth++
    if (!hidden && $0 !~ /^:::+ *\{#tab:/)
        hidden = depth
    next
}
/^:::+ *$/ {
    if (hidden == depth)
        hidden = 0
    depth--
    next
}
!hidden
