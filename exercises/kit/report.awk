# Reports two runs of a grader: usage
#   awk -f report.awk -v key=2.1 -v title=TITLE -v why=yes -v out=SCORES
#       FIRST SECOND
# Tells every failure, prints the score table, and writes both runs as
# one table: a test earns what it earns in both. A row without a seed
# was lost with all others. What could not be graded is worth nothing.
# With why=no, nothing is said of the likely causes.

BEGIN { FS = OFS = "\t" }
FNR == 1 { run++; head = $0; next }
why == "no" && $6 != "" { $11 = "" }
!($1 in about) { names[++tests] = $1; about[$1] = $5 }
{
    status[$1, run] = $4 == "wrong" && $2 > 0 ? "partly" : $4
    points[$1] = $1 in row && points[$1] < $2 ? points[$1] : $2
    worth[$1] = $3
    row[$1] = $0
    runs[$1] = run
    if ($12 != "") # in a race, also of those that pass
        ratio[$1] = $12
}
$4 != "passed" { tell() }

# A labelled text, wrapped at 72 columns.
function line(label, text,    words, n, i, width) {
    if (text == "")
        return
    printf "    %-9s", label
    n = split(text, words, " ")
    for (i = 1; i <= n; i++) {
        width += length(words[i]) + 1
        if (width > 59 && i > 1) {
            printf "\n%13s", ""
            width = length(words[i]) + 1
        }
        printf " %s", words[i]
    }
    print ""
}

# What a crash has in common with the same one on another input: the
# line and the words, but not the numbers.
function kind(    place, words) {
    words = $10
    if (match(words, /, in line [0-9]+ of .*/)) {
        place = substr(words, RSTART)
        words = substr(words, 1, RSTART - 1)
    }
    gsub(/[0-9][0-9a-fx]*/, "N", words)
    return words place $11
}

function headline() {
    if ($4 == "not graded")
        return "NOT GRADED"
    return $4 == "wrong" ? $2 > 0 ? "PARTLY" : "WRONG" : "FAILED"
}

# A crash is told once, with the tests in which it happens again; what
# earns a part of its points, once of the two runs, unless it earns less
# in the second.
function tell() {
    if ($6 == "") { # it is the file, not the test
        if (!told++) {
            printf "\nFAILED  Nothing was tested.\n"
            line("why", $10)
        }
        return
    }
    if ($1 in partly && $2 >= partly[$1])
        return
    if ($4 == "wrong" && $2 > 0)
        partly[$1] = $2
    if ($9 == "" && kind() in first) {
        again[first[kind()]] = again[first[kind()]] " " $1
        return
    }
    first[kind()] = $1
    printf "\n%s  %s: %s\n", headline(), $1, $5
    line("where", $8)
    line("expected", $9)
    line("found", $10)
    line("why", $11 in told_in ? "the same as " before() : $11)
    if ($11 != "" && !($11 in told_in))
        told_in[$11] = $1
    line("input", $7 ($7 != "" ? ", " : "") "seed " $6)
    line("again", "make exercise" key " TEST=" $1 " SEED=" $6)
}

# The test whose cause was the same.
function before() {
    return told_in[$11] == $1 ? "before" : "in " told_in[$11]
}

function cell(name, run) {
    if (status[name, 1] == "does not compile") # over both columns
        return run == 1 ? "does not" : "compile"
    if (!((name, run) in status))
        return "-"
    return length(status[name, run]) > 10 ? "failed" : status[name, run]
}

END {
    for (t = 1; t <= tests; t++)
        if (again[names[t]] != "")
            printf "\nThe same as in %s happens in:%s\n", names[t],
                again[names[t]]
    printf "\nExercise %s: %s\n\n", key, title
    printf "  %-44s %-10s %-10s %s\n", "", "sanitized", "optimized", "points"
    print head > out
    for (t = 1; t <= tests; t++) {
        n = names[t]
        $0 = row[n]
        if (runs[n] < 2) # no points without the second run
            points[n] = 0
        $2 = points[n]
        print > out
        printf "  %-44s %-10s %-10s %2d / %d\n", about[n], cell(n, 1),
            cell(n, 2), points[n], worth[n]
        if (n in ratio)
            printf "    in %.2f times the time of the program beside it\n",
                ratio[n]
        earned += points[n]
        of += worth[n]
    }
    printf "  %-44s %-10s %-10s %2d / %d\n", "", "", "", earned, of
    exit earned < of
}
