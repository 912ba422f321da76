# What the phases of a step take.
# alt: Nanoseconds a triangle for each of five phases over the number of
# triangles, both axes logarithmic. Capture and predict are level. The
# broad phase by clusters is a little above them, the narrow phase is
# mostly the highest.
# demo: plot
height = 2.9
load "book/figures/style.gp"
table = data . "/ch13-phases.tsv"
of(value) = strcol("broad") eq "clusters" && value > 0 ? value : NaN
set logscale xy
set format x powers
set xlabel "triangles"
set ylabel "nanoseconds a triangle"
set key outside right center
set datafile missing NaN
plot table using "triangles":(of(column("predict"))) title "predict", \
  table using "triangles":(of(column("capture"))) title "capture", \
  table using "triangles":(of(column("broad_ns"))) title "broad phase", \
  table using "triangles":(of(column("narrow_ns"))) title "narrow phase", \
  table using "triangles":(of(column("handle"))) title "handle", \
  table using "triangles":(of(column("step"))) title "whole step"
