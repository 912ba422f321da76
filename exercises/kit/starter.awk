# Derives the starter from exercises/chNN/K-name/solution.c. The opening
# comment, which says how it is done, is replaced by what the exercise
# is called and where its task is. What stands between the comments
# "//- solution" and "//- starter" is left out, and the comments between
# "//- starter" and "//- end" become code. Of empty lines that meet where
# a part was left out, one stays.
BEGIN {
    text = ARGV[1]
    sub(/solution\.c$/, "exercise.md", text)
    split(text, folders, "/")
    key = substr(folders[2], 3) + 0 "." folders[3] + 0
    while ((getline line < text) > 0)
        if (sub(/^title: */, "", line))
            print "// Exercise " key ": " line
    print "// What to write is in task.md, beside this file."
}
!begun && /^\/\/($|[^-])/ { next }
{ begun = 1 }
/^ *\/\/- solution$/ { part = "solution"; next }
/^ *\/\/- starter$/ { part = "starter"; next }
/^ *\/\/- end$/ { part = ""; next }
part == "solution" { next }
part == "starter" { sub(/\/\/ ?/, "") }
!NF && empty { next }
{ empty = !NF; print }
