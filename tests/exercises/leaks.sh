#!/bin/sh
# The student's edition holds no run of a solution's tokens,
# whatever its names are; and the search for such runs finds those that
# are planted, among them two that once stood in tests.
place=$(mktemp -d) || exit 1
trap 'rm -rf "$place"' EXIT
said=$place/said

search() {
    texlua exercises/course/leaks "$@" >"$said" 2>&1
}

# plant NAME FOLDER: from the standard input, as a file that leaks the
# solution of this folder.
plant() {
    mkdir -p "$place/planted"
    cat >"$place/planted/$1.c"
    echo "$1 $2" >>"$place/list"
}

(
    . exercises/course/pack.sh
    give_book "$place/packed"
) && search "$place/packed"
if [ $? -eq 0 ]; then
    echo "ok nothing that is packed leaks a solution"
else
    sed "s,$place/packed/,,; s,^leaks: ,not ok ," "$said" | grep '/'
fi

plant search ch02/1-nearest-pair <<'END'
static struct pair search(struct points points, bool furthest)
{
    struct pair best = {0, 1, between(points, 0, 1)};
    for (uint32_t i = 0; i < points.n; i++)
        for (uint32_t j = 0; j < points.n; j++) {
            double d2 = between(points, i, j);
            if (i < j &&
                (furthest ? d2 > best.distance2 : d2 < best.distance2))
                best = (struct pair){i, j, d2};
        }
    return best;
}
END
plant insertion ch02/4-k-nearest <<'END'
static void insert_all(struct points points, uint32_t i)
{
    uint32_t found = 0;
    for (uint32_t j = 0; j < points.n; j++) {
        double d2 = distance2(points.x[j] - points.x[i],
                              points.y[j] - points.y[i]);
        if (j == i || (found == KEPT && d2 >= distances2[KEPT - 1]))
            continue;
        uint32_t place = found < KEPT ? found++ : KEPT - 1;
        for (; place > 0 && distances2[place - 1] > d2; place--)
            distances2[place] = distances2[place - 1];
        distances2[place] = d2;
    }
}
END

# A solution under other names, with other integers and no line breaks.
sed -n '/^\/\/- solution/,/^\/\/- starter/p' \
    exercises/ch03/4-pair-in-parallel/solution.c >"$place/part"
grep -v '//' "$place/part" | sed 's/pair/couple/g; s/better/wins/g' | tr '\n' ' ' |
    sed 's/  */ /g' | plant renamed ch03/4-pair-in-parallel
sed -n '/^\/\/- solution/,/^\/\/- starter/p' exercises/ch04/4-back-in-order/solution.c |
    grep -v '//' | sed 's/uint32_t/unsigned long/g; s/start/begin/g' |
    plant other-integers ch04/4-back-in-order


for solution in exercises/ch*/*/solution.c; do
    awk -f exercises/kit/starter.awk "$solution"
done >"$place/planted/starters.c"
mkdir -p "$place/planted/exercises/ch04/2-how-many-between"
: >"$place/planted/exercises/ch04/2-how-many-between/naive.c"
echo "naive a file of this name" >>"$place/list"
search "$place/planted"
while read -r name origin; do
    grep "/$name.c:.*$origin" "$said" >"$place/found" &&
        echo "ok a leak of $origin: $name" ||
        echo "not ok a leak of $origin: $name: $(tr '\n' ' ' <"$said")"
done <"$place/list"
grep 'starters.c:' "$said" >"$place/found" &&
    echo "not ok a starter is no leak: $(cat "$place/found")" ||
    echo "ok a starter is no leak"
