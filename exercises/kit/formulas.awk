# Formulas between dollars as a terminal can show them: $2^{-24}$ is
# 2^-24, $O(\sqrt n)$ is O(sqrt(n)), $t \le m$ is t <= m. Code stays.

# The text of a group, or the single character, at the beginning of
# rest, which it shortens.
function argument(    depth, i, c, text) {
    sub(/^ */, "", rest)
    if (substr(rest, 1, 1) != "{") {
        text = substr(rest, 1, 1)
        rest = substr(rest, 2)
        return text
    }
    for (i = 1; i <= length(rest); i++) {
        c = substr(rest, i, 1)
        depth += (c == "{") - (c == "}")
        if (depth == 0)
            break
    }
    text = substr(rest, 2, i - 2)
    rest = substr(rest, i + 1)
    return text
}

function within(text,    saved) {
    saved = rest
    text = formula(text)
    rest = saved
    return text
}

# What a command stands for. A word keeps its distance.
function command(name, before) {
    if (name == "sqrt")
        return "sqrt(" within(argument()) ")"
    if (name == "text" || name ~ /^math/)
        return within(argument())
    if (name == "lceil") {
        sub(/^ */, "", rest)
        return "ceil("
    }
    if (name == "rceil")
        return ")"
    if (name in symbols)
        return symbols[name]
    return name
}

function formula(text,    all, name, word) {
    rest = text
    all = ""
    while (rest != "") {
        if (match(rest, /^\\[a-zA-Z]+/)) {
            name = substr(rest, 2, RLENGTH - 1)
            rest = substr(rest, RLENGTH + 1)
            if (name == "rceil")
                sub(/ *$/, "", all)
            word = command(name)
            all = all (all ~ /[A-Za-z0-9)]$/ && word ~ /^[a-z]/ ? " " : "") word
        } else if (rest ~ /^\\/) { # a space, thin or not
            all = all " "
            rest = substr(rest, 3)
        } else if (rest ~ /^[\^_]\{/) {
            name = substr(rest, 1, 1)
            rest = substr(rest, 2)
            word = within(argument())
            all = all name (word ~ /^-?([0-9.]+|[A-Za-z]+)$/ ? word : "(" word ")")
        } else {
            name = substr(rest, 1, 1)
            rest = substr(rest, 2)
            if (name != "{" && name != "}")
                all = all name
        }
    }
    return all
}

BEGIN {
    symbols["le"] = "<="
    symbols["ge"] = ">="
    symbols["ne"] = "!="
    symbols["cdot"] = "*"
    symbols["times"] = "*"
    symbols["dots"] = "..."
    symbols["infty"] = "infinity"
    symbols["int"] = "integral of"
    symbols["sum"] = "sum of"
}
/^```/ { code = !code }
code || !/\$/ { print; next }
{
    line = $0
    out = ""
    # A formula begins before a character and ends behind one; what
    # stands between grave accents is code.
    while (match(line, /`[^`]*`|\$[^ $]\$|\$[^ $][^$]*[^ $]\$/)) {
        found = substr(line, RSTART, RLENGTH)
        out = out substr(line, 1, RSTART - 1)
        line = substr(line, RSTART + RLENGTH)
        out = out (found ~ /^`/ ? found : formula(substr(found, 2, length(found) - 2)))
    }
    print out line
}
