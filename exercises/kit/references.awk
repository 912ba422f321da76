# The references of an exercise's text, as the book prints them: for
# @ex:ch06-unpack Exercise 6.2, by its folder; for figures, tables,
# sections and chapters their numbers, counted in chapters/ as the press
# counts them. Citations in brackets are left out: the book has the list.
{
    gsub(/ *\[-?@[a-z0-9-]+\]/, "")
    text = $0
    while (match(text, /@(ex|fig|tab|sec|ch):[a-z0-9-]*[a-z0-9]/)) {
        before = substr(text, 1, RSTART - 1)
        label = substr(text, RSTART + 1, RLENGTH - 1)
        text = substr(text, RSTART + RLENGTH)
        printf "%s%s", before, title_of(label)
    }
    print text
}

function title_of(label,    kind) {
    kind = label
    sub(/:.*/, "", kind)
    if (kind == "ex" && !(label in names))
        look_for_exercises()
    else if (kind != "ex" && !counted++)
        count_chapters()
    return label in names ? names[label] : "@" label
}

function look_for_exercises(    list, text, part, name) {
    list = "printf '%s\\n' exercises/ch*/*/exercise.md"
    while ((list | getline text) > 0) {
        split(text, part, "/")
        name = part[3]
        sub(/^[0-9]+-/, "", name)
        names["ex:" part[2] "-" name] = \
            "Exercise " substr(part[2], 3) + 0 "." part[3] + 0
    }
    close(list)
}

function count_chapters(    list, file, id, number, appendices) {
    list = "printf '%s\\n' chapters/*.md"
    while ((list | getline file) > 0) {
        id = file
        gsub(/^chapters\/|\.md$/, "", id)
        if (id ~ /^appendix-/) {
            number = sprintf("%c", 65 + appendices++)
            names["ch:" id] = "Appendix " number
        } else {
            id = substr(id, 1, 4)
            number = substr(id, 3) + 0
            names["ch:" id] = "Chapter " number
        }
        count(file, number)
    }
    close(list)
}

function count(file, number,    line, last, code) {
    while ((getline line < file) > 0) {
        if (line ~ /^```/)
            code = !code
        if (code)
            continue
        if (line ~ /^## / && line !~ /\{.*(\.unnumbered|-\}).*/)
            take(line, "sec", "Section " number "." ++last["sec"])
        else if (line ~ /^!\[/)
            take(line, "fig", "Figure " number "." ++last["fig"])
        else if (line ~ /^:::+ *\{#tab:/)
            take(line, "tab", "Table " number "." ++last["tab"])
    }
    close(file)
}

# The name of what has a label of this kind in the line.
function take(line, kind, name) {
    if (match(line, "#" kind ":[a-z0-9-]+"))
        names[substr(line, RSTART + 1, RLENGTH - 1)] = name
}
