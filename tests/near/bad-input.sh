#!/bin/sh
# Every mistake in a file gets its sentence and status 2.
. "$(dirname "$0")/checks"

# bad NAME CONTENT SENTENCE [ARGUMENTS]
bad() {
    name=$1 sentence=$3
    printf "$2" >cities.csv
    shift 3
    refuses "$name" "$sentence" cities.csv "$@"
    rm cities.csv
}

bad 'a letter in a number' 'x,y\n1,2\n12.5,abc\n' \
    'cities.csv:3: expected two numbers, found "12.5,abc"'
bad 'one column' '1\n2\n' 'cities.csv:1: expected two numbers, found "1"'
bad 'three columns' '1 2 3\n' 'cities.csv:1: expected two columns (or --columns I,J)'
bad 'an empty file' '' 'cities.csv: expected points, found none'
bad 'only a header' 'x y\n' 'cities.csv: expected points, found none'
bad 'one point' '1 2\n' 'cities.csv: expected at least two points, found one'
bad 'NaN' '1 2\nnan 3\n' 'cities.csv:2: expected finite numbers, found "nan 3"'
bad 'infinity' '1 2\n-inf 3\n' 'cities.csv:2: expected finite numbers'
bad 'a number too large' '1 2\n1e999 3\n' 'cities.csv:2: expected finite numbers'
bad 'a binary file' '\177ELF\001\002\000\000\n' \
    'cities.csv:1: expected text, found a binary file'
bad 'a column that is not there' '1,2\n' \
    'cities.csv:1: expected numbers in the two columns' --columns 1,3
bad 'a long line is not quoted whole' "$(printf '%0200d' 0)x 2\n" \
    'cities.csv:1: expected two numbers, found "0000000000'
bad 'a file cut short' \
    'NAME: c\nDIMENSION: 5\nNODE_COORD_SECTION\n1 1 1\n2 2 2\n' \
    'cities.csv:5: expected 5 points, as DIMENSION says, found 2'
bad 'a file cut in a line' \
    'NAME: c\nDIMENSION: 2\nNODE_COORD_SECTION\n1 1 1\n2 2\n' \
    'cities.csv:5: expected a point'
bad 'a point whose number is none' \
    'DIMENSION: 1\nNODE_COORD_SECTION\nbanana 0 0\n' \
    'cities.csv:3: expected a point'
bad 'half a point too many' 'DIMENSION: 2.5\nNODE_COORD_SECTION\n' \
    'cities.csv:1: expected the number of points'
bad 'places on a globe' 'EDGE_WEIGHT_TYPE : GEO\n' \
    'cities.csv:1: expected points in a plane'
bad 'points at one huge place' '1e20 5\n1e20 6\n' \
    'the point (1e+20, 5) lies outside the box that wraps around; name one that holds all points, such as --box 1e+20,5,1.0000000000000002e+20,6' -g wraparound
bad 'points too far apart for a box' '1e308 0\n-1e308 0\n' \
    'the points are too far apart for a box' -g wraparound
bad 'the file that holds the points' '1 2\n3 4\n' \
    '-o: ./cities.csv holds the points' -o ./cities.csv
refuses 'a line without end' 'standard input:1: expected text, found a line without end' - <<END
$(printf '%01100000d' 1)
END
bad 'outside the unit square' '0 0\n565 575\n' \
    'the point (565, 575) lies outside the box that wraps around; name one that holds all points, such as --box 0,0,565,575' \
    -g wraparound
bad 'outside the box named' '0 0\n565 575\n' \
    'the point (565, 575) lies outside the box' \
    -g wraparound --box 0,0,500,600

refuses 'a missing file' 'cannot open nowhere.csv: No such file' nowhere.csv
refuses 'a folder' 'cannot read /: Is a directory' /
refuses 'a bad line from standard input' 'standard input:2: expected two numbers, found "3"' - <<END
1 2
3
END
refuses 'nothing from standard input' 'standard input: expected points' - </dev/null

printf '1 2\n3 x\n' >cities.csv
echo before >answers.tsv
refuses 'a bad file leaves the old answers' 'cities.csv:2:' \
    cities.csv -o answers.tsv
says 'which are as they were' before "$(cat answers.tsv)"
refuses 'a bad file makes no answers' 'cities.csv:2:' cities.csv -o new.tsv
