# What the scripts of the kit share; sourced, not run.
: "${BUILD:=build}" "${CC:=cc}" "${WORK:=work}"
export BUILD CC
unset ASAN_OPTIONS UBSAN_OPTIONS # the kit has its own
kit=exercises/kit

die() {
    echo "$(basename "$0"): $*" >&2
    exit 2
}

usage() {
    die "say make exercise2.1 for exercise 1 of chapter 2"
}

# key_of exercises/ch02/1-nearest-pair/exercise.md: 2.1
key_of() {
    echo "$1" | sed 's,[^/]*/ch0*\([0-9]*\)/\([0-9]*\).*,\1.\2,'
}

# find_exercise 2.1 sets key, folder, id, slug, title and worth:
# exercises/ch02/1-nearest-pair, ch02/1-nearest-pair, nearest-pair, and
# from the text the title and how many points.
find_exercise() {
    key=$1
    case $key in
    *[!0-9.]* | .* | *. | *.*.*) usage ;;
    *.*) ;;
    *) usage ;;
    esac
    folder=$(printf 'exercises/ch%02d/%d-*' "${key%%.*}" "${key#*.}")
    # shellcheck disable=SC2086 # the pattern is meant to expand
    set -- $folder
    [ $# -eq 1 ] && [ -d "$1" ] || die "there is no exercise $key"
    folder=$1
    id=${folder#exercises/}
    title=$(sed -n 's/^title: *//p' "$folder/exercise.md")
    worth=$(sed -n 's/^points: *//p' "$folder/exercise.md")
    slug=$(basename "$folder" | sed 's/^[0-9]*-//')
}

# next_key exercise.md: the exercise after this one, of those here; with
# tests.c, of those that are programmed
next_key() {
    for text in exercises/ch*/*/"$1"; do
        key_of "$text"
    done | sort -t . -k 1,1n -k 2,2n | awk -v key="$key" '
        found { print; exit }
        $0 == key { found = 1 }'
}

# The starter of the exercise, as students get it.
put_starter() {
    if [ -f "$folder/starter.c" ]; then
        cat "$folder/starter.c"
    elif [ -f "$folder/solution.c" ]; then
        awk -f $kit/starter.awk "$folder/solution.c"
    else
        return 1
    fi
}

# The task of the exercise: its text without hints and answer.
put_task() {
    echo "Exercise $key: $title"
    awk -f $kit/task.awk "$folder/exercise.md" | plain
}

# put_work TO: what somebody needs who begins, unless it is there.
put_work() {
    mkdir -p "$1" && put_task >"$1/task.md" && cp "$folder/exercise.h" "$1" ||
        die "cannot write to $1"
    [ -e "$1/$slug.c" ] && return
    put_starter >"$1/$slug.c" || die "cannot write to $1"
    echo "Made $1/$slug.c from the starter; the task is in $1/task.md."
}

# make, whatever the make that may have called us was told
quiet_make() {
    LC_ALL=C MAKEFLAGS= MFLAGS= make -s -f $kit/kit.mk "$@"
}

# The text without the press's markup, references, TeX and spaces.
plain() {
    awk -f $kit/references.awk | awk -f $kit/formulas.awk | sed 's/\[\([^]]*\)\]{\.[^}]*}/\1/g' |
        cat -s | fold -s -w 72 | sed 's/ *$//'
}
