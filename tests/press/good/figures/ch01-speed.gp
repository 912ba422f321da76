set terminal pdfcairo size 4.7,2.4 font "TeX Gyre Pagella,9"
set output output
plot x, x/10
