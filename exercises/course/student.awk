# An exercise's text as students get it: without the model answer, the
# reasoning and the advice for marking. Hints stay, for `make hint`; any
# other kind of division is not for students, unless it is a table.
/^:::+ *[^: ]/ {
    depth++
    if (!hidden && $0 !~ /^:::+ *(hint *$|\{#tab:)/)
        hidden = depth
}
!hidden { print }
/^:::+ *$/ {
    if (hidden == depth)
        hidden = 0
    depth--
}
