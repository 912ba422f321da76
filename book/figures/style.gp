# The one style of all figures. The caller sets
#   format   pdf, svg, png, dumb (the terminal) or slide (a PDF with
#            letters that can be read from afar)
#   output   the file to write; unused for dumb
#   data     the folder of the tables
# A figure may set `height` (in inches) before it loads this file; all
# are as wide as the book's text. Lines differ in dash and point shape,
# not only in color, so that they survive a black and white printer.
if (!exists("height")) height = 2.9
width = 4.7
if (format eq "slide") width = 5.6

if (format eq "pdf") set terminal pdfcairo size width,height \
  font "TeX Gyre Pagella,9" fontscale 0.75 linewidth 1 rounded
if (format eq "slide") set terminal pdfcairo size width,height \
  font "TeX Gyre Pagella,10" fontscale 0.8 linewidth 1.2 rounded
if (format eq "svg") set terminal svg size width*110,height*110 \
  font "serif,12" background "white" dynamic
if (format eq "png") set terminal pngcairo size width*200,height*200 \
  font "TeX Gyre Pagella,9" fontscale 2 linewidth 2 background "white"
if (format eq "dumb") set terminal dumb size 78,24 noenhanced
if (format ne "dumb") set output output

# How an axis of powers of ten is labeled, `set format x powers`: as
# 10 with an exponent, in the terminal as 1, 10, 1 k, 1 M.
powers = format eq "dumb" ? "%.0s %c" : "10^{%T}"

set encoding utf8
set datafile separator tab
set datafile commentschars "#"
set datafile columnheaders

# Six lines, from dark blue to gray.
set linetype 1 lc rgb "#14447c" lw 1.6 dt 1     pt 7  ps 0.55
set linetype 2 lc rgb "#c4511a" lw 1.6 dt (8,3) pt 5  ps 0.50
set linetype 3 lc rgb "#2f7d4f" lw 1.6 dt (3,3) pt 9  ps 0.65
set linetype 4 lc rgb "#7a4a94" lw 1.6 dt (9,3,2,3) pt 13 ps 0.65
set linetype 5 lc rgb "#8c6d1f" lw 1.6 dt (2,4) pt 4  ps 0.55
set linetype 6 lc rgb "#555555" lw 1.6 dt (12,4) pt 6  ps 0.55
set linetype cycle 6

# Style 10: frame and ticks. Style 11: a limit. Style 12: a light fill.
set style line 10 lc rgb "#444444" lw 0.7
set style line 11 lc rgb "#000000" lw 1.0 dt (4,3)
set style line 12 lc rgb "#c9d6e6" lw 0.5

set border 3 ls 10
set tics nomirror out scale 0.6
set xtics textcolor rgb "#222222"
set ytics textcolor rgb "#222222"
set grid ytics lc rgb "#dddddd" lw 0.5 dt 1
set key top left reverse Left samplen 2.6 spacing 1.15
set style fill solid 0.35 border
set boxwidth 0.7 relative
set style data linespoints
