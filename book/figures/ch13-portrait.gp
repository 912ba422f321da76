# A small pile, drawn by the program.
# alt: Two pictures of thirty bodies, spheres, tori and boxes made of
# triangles. On the left they fall and a few touch; on the right they lie
# in a heap on the floor of a box. Triangles with a contact are dark,
# and drawn on top.
height = 2.5
load "book/figures/style.gp"
table = data . "/ch13-portrait.tsv"
unset border; unset tics; unset grid; unset key
set multiplot layout 1,2 margins 0,1,0,1 spacing 0
set view 70,30
set view equal xyz
set pm3d depthorder border linecolor "#222222" linewidth 0.3
set pm3d lighting primary 0.5 specular 0
set style fill solid 1
set xrange [-4.2:4.2]; set yrange [-4.2:4.2]; set zrange [-1:7]
set xyplane at -1
do for [step in "70 300"] {
  of(x, dark) = sprintf("%d", column("frame")) eq step && column("dark") == dark ? x : NaN
  splot table using (of(column("x"), 0)):"y":"z" with polygons fillcolor rgb "#b3c6de", \
    table using (of(column("x"), 1)):"y":"z" with polygons fillcolor rgb "#e0661f"
}
unset multiplot
