#!/bin/sh
# The program contact: scenes, tables, pictures, and a sentence for
# every mistake.
program=contact
. "$(dirname "$0")/../near/checks"

# Every scene, every broad phase, compared with all pairs.
for scene in cloud:12 giant:8 bullet:6 cloth:10 rings:6 pile:10; do
    for broad in $("$near" --list | sed -n '/^broad/,$s/^  \([^ ]*\) .*/\1/p'); do
        accepts "${scene%:*} by $broad" --scene "${scene%:*}" \
            -n "${scene#*:}" --steps 6 -a "$broad" --check -t 2
    done
done
accepts 'a pile falls' --scene pile -n 8 --steps 120 --check
says 'what check says' 'check: all 120 steps are right' "$(tail -n 1 "$out")"

accepts 'a table of steps' --scene pile -n 3 --steps 5 -o steps.tsv
says 'a row a step, and a head' 6 "$(wc -l <steps.tsv | tr -d ' ')"
says 'its first columns' "$(printf 'step\ttested\tcandidates')" \
    "$(head -n 1 steps.tsv | cut -f 1-3)"
rm steps.tsv
run --scene bullet -n 6 --steps 8 --events -o - -t 1
cp "$out" one
run --scene bullet -n 6 --steps 8 --events -o - -t 4 -a sweep
says 'the same contacts by threads' "$(cat one)" "$(cat "$out")"
says 'a bullet has contacts' yes \
    "$([ "$(wc -l <one)" -gt 1 ] && echo yes)"
cloth="--scene cloth -n 20 --steps 30 --passive --events -o -"
run $cloth -t 1
cp "$out" one
run $cloth -t 4
says 'the same, where edges are touched twice' "$(cat one)" \
    "$(cat "$out")"
rm one

# A scene in a file: two spheres that meet in the middle, radius 1, at
# the end of a step of 0.01.
cat >two.scene <<'END'
# two balls
sphere 2 at -1.5 0 0 velocity 100 0 0
sphere 2 at 1.5 0 0 velocity -100 0 0 spin 0 0 0
END
accepts 'a scene from a file' two.scene --steps 2 --check
says 'its bodies' 'scene       2 bodies, 640 triangles, 324 nodes' \
    "$(head -n 1 "$out")"
run two.scene --steps 1 --events -o -
says 'they touch half way' yes "$(awk 'NR > 1 && $7 > 0.45 && $7 < 0.55 &&
    $8 > -0.1 && $8 < 0.1 { n++ } END { if (n > 0) print "yes" }' "$out")"
accepts 'passive balls' two.scene --steps 3 --passive
run - --steps 1 <two.scene
says 'a scene from standard input' 0 $status

mkdir folder
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n' \
    >folder/four.off
printf 'file four.off size 2\nbox 1 at 5 0 0 fixed\ncloth 2 at 0 9 0 soft\ngravity 0 0 -1\n' \
    >folder/scene
accepts 'a mesh beside the scene' folder/scene --steps 3 --check
says 'all of it' 'scene       3 bodies, 24 triangles, 21 nodes' \
    "$(head -n 1 "$out")"
accepts 'pictures' folder/scene --steps 30 --pictures shots
says 'a script and some pictures' 16 "$(ls shots | wc -l | tr -d ' ')"
if command -v gnuplot >/dev/null; then
    (cd shots && timeout 100 gnuplot pictures.gp >"$out" 2>&1)
    says 'drawn' 15 "$(ls shots/*.png 2>/dev/null | wc -l | tr -d ' ')"
fi
rm -r shots
accepts 'the manual' --help
says "what stays" yes "$(grep -q "stay where they are" "$out" && echo yes)"
says "what is refused" yes "$(grep -q "touch at the beginning are refused" "$out" && echo yes)"

refuses 'no scene' 'which scene?'
refuses 'two scenes' 'the scene comes from a file or from --scene' \
    --scene pile two.scene
refuses 'an unknown scene' '--scene: there is no scene "heap"' --scene heap
refuses 'an unknown broad phase' '-a: there is no broad phase "x"' \
    --scene pile -a x
refuses 'an unknown option' 'what is --bax?' --bax
refuses 'no steps' '--steps: expected a whole number' --scene pile \
    --steps 0
refuses 'a time backwards' '--dt: expected a number' --scene pile --dt -1
refuses 'no ring' '-n: rings can have a size from 3' --scene rings -n 2
refuses 'a size for a file' '-n is for a scene of the list' -n 3 two.scene
refuses 'events without a table' '--events is what -o writes' \
    --scene pile --events
refuses 'no file' 'cannot open nowhere' nowhere
refuses 'two files' 'one FILE at a time' two.scene two.scene
refuses 'no folder for pictures' 'cannot make no/folder' two.scene \
    --pictures no/folder
refuses 'a table that cannot be written' 'cannot write no/file' \
    two.scene -o no/file

# bad NAME SENTENCE TEXT: of a scene
bad() {
    printf "$3" >bad.scene
    refuses "$1" "bad.scene$2" bad.scene
}
bad 'an empty scene' ': expected bodies, found none' '# nothing\n'
bad 'an unknown shape' ':1: expected sphere, torus, box' 'cone 3\n'
bad 'no cuts' ':2: expected sphere and its cuts' 'box 1\nsphere\n'
bad 'too many cuts' ':1: expected sphere and its cuts' 'sphere 40\n'
bad 'half a cut' ':1: expected box and its cuts' 'box 1.5\n'
bad 'two coordinates' ':1: expected at and three numbers' 'box 1 at 1 2\n'
bad 'an infinite place' ':1: expected at and three' 'box 1 at 1 2 inf\n'
bad 'no size' ':1: expected size and a number above 0' 'box 1 size 0\n'
bad 'an unknown word' ':1: expected at, size, velocity' 'box 1 red\n'
bad 'gravity and more' ':1: expected gravity and three' \
    'gravity 0 0 1 2\n'
bad 'a file without a name' ':1: expected file and the name' 'file\n'
bad 'crossing bodies' ': bodies 0 and 1, numbered from 0, touch' \
    'box 1\nbox 1 at 0.5 0.5 0.5\n'
bad 'touching bodies' ': bodies 0 and 1, numbered from 0, touch' \
    'box 1\nbox 1 at 2 0 0\n'
accepts 'unless they only pass' bad.scene --passive --steps 2
bad 'crossing sheets that stay' ': bodies 0 and 1, numbered from 0, touch' \
    'cloth 1 fixed\nbox 1 at 0.3 0.2 0\n'
for mesh in 'off OFF\n3_1_0\n0_0_nan\n :3' 'obj v_0_0_0\nv_0_-inf_0\n :2' \
    'stl solid\nfacet\nouter\nvertex_1_2_inf\n :4'; do
    set -- $mesh
    printf "file bad.$1\n" >bad.scene
    printf "$(echo "$2" | tr _ ' ')" >"bad.$1"
    refuses "no number in $1" "bad.$1$3: expected" bad.scene
    rm "bad.$1"
done
printf 'file bad.off\n' >bad.scene
printf 'OFF\n1 1 0\n0 0 0\n3 0 1 2\n' >bad.off
refuses 'a bad mesh' 'bad.off:4: expected a number of corners' bad.scene
printf 'file none.ply\n' >bad.scene
refuses 'a mesh of another kind' 'none.ply: expected a file whose name' \
    bad.scene
printf 'box 1 velocity 1e9 0 0\nbox 1 at 9 9 9 velocity -1e9 0 0\n' >fast
accepts 'what moves fast' fast --dt 1e9 --steps 1 --check
