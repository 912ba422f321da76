# What goes into the archives for students and for graders. Sourced by
# `sheet`, `handout` and `release`, in the project's root.
. exercises/kit/common.sh
course=exercises/course

# give_exercise FOLDER TO: the exercise as a student may have it, with
# the starter beside it and without the solution.
give_exercise() {
    mkdir -p "$2/$1" || die "cannot write to $2"
    awk -f $course/student.awk "$1/exercise.md" | cat -s >"$2/$1/exercise.md"
    [ -f "$1/tests.c" ] || return 0
    cp "$1/exercise.h" "$1/tests.c" "$2/$1" &&
        awk -f $kit/starter.awk "$1/solution.c" >"$2/$1/starter.c"
}

# give_kit TO: what exercises are run with, not what they are made with.
give_kit() {
    mkdir -p "$1/$kit" "$1/code" && cp -R $kit "$1/exercises" &&
        cp -R code/common "$1/code" || die "cannot write to $1"
    for mine in check README.md starter.awk; do
        rm "$1/$kit/$mine"
    done
}

# give_book TO: the student's edition of the whole project, without
# solutions, model answers, mutants and what only instructors need.
give_book() {
    mkdir -p "$1/tests" || die "cannot write to $1"
    cp -R code chapters book LICENSE CITATION.cff CHANGES.md \
        CONTRIBUTING.md Makefile setup .clang-format "$1" ||
        die "cannot copy the book"
    rm -rf "$1/book/manual"
    # The tests of exercises, of grading and of courses need solutions.
    for folder in tests/*; do
        case ${folder#tests/} in
        exercises | grade | sheet | manual | release | export | check-release) ;;
        *) cp -R "$folder" "$1/tests" ;;
        esac
    done
    for folder in exercises/ch*/*/; do
        give_exercise "${folder%/}" "$1"
    done
    give_kit "$1"
    awk '/^<!-- Editions/ { hidden = 1 }
        /^## / { hidden = /^## For a course/ }
        /^\| `exercises\/` / {
            $0 = "| `exercises/` | a folder an exercise: text, tests, starter; `kit/` runs them |"
        }
        !hidden
        /^<!-- The editions end/ { hidden = 0 }' README.md >"$1/README.md"
    (cd "$1" && find . -name '*~' -o -name '.*.sw?') |
        while IFS= read -r left; do rm "$1/$left"; done
}

# pack_tar FOLDER NAME: NAME.tar.gz in FOLDER from the folder NAME there.
# Who packed it, and when, is nobody's business.
pack_tar() {
    anonymous=
    tar --version 2>/dev/null | grep -q GNU &&
        anonymous="--owner=0 --group=0 --numeric-owner --sort=name"
    # shellcheck disable=SC2086 # a list of words
    (cd "$1" && tar $anonymous -cf - "$2" | gzip -n >"$2.tar.gz") ||
        die "cannot pack $2"
}
