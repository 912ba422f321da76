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

# make, whatever the make that may have called us was told
quiet_make() {
    LC_ALL=C MAKEFLAGS= MFLAGS= make -s -f $kit/kit.mk "$@"
}

# The text without the press's markup and the press's spaces.
plain() {
    sed -e 's/\[\([^]]*\)\]{\.[^}]*}/\1/g' -e 's/@fig:/the figure /g' |
        cat -s | fold -s -w 72 | sed 's/ *$//'
}
