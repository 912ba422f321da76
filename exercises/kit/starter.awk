# Derives the starter from a solution: what stands between the comments
# "//- solution" and "//- starter" is left out, and the comments between
# "//- starter" and "//- end" become code.
/^ *\/\/- solution$/ { part = "solution"; next }
/^ *\/\/- starter$/ { part = "starter"; next }
/^ *\/\/- end$/ { part = ""; next }
part == "solution" { next }
part == "starter" { sub(/\/\/ ?/, "") }
{ print }
