# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "data='growth.csv'" growth.gp: time and operations over the length of a chain, as SVG.
set terminal svg size 860,360 font "sans-serif,12" background "white"
set datafile separator ","
set key top left
set grid
set xlabel "joints"
set logscale xy
set xrange [1.8:34]
set xtics (2, 4, 6, 8, 10, 15, 20, 30)
set multiplot layout 1,2
set title "sinew generate, processor time"
set ylabel "s"
plot data using 1:2 every ::1 with linespoints pt 7 lc rgb "#1b6ca8" title "all functions of a chain"
set title "what is emitted"
set ylabel "multiplications and additions"
plot data using 1:3 every ::1 with linespoints pt 7 lc rgb "#1b6ca8" title "inverse dynamics", \
     data using 1:4 every ::1 with linespoints pt 5 lc rgb "#c8553d" title "mass matrix", \
     data using 1:5 every ::1 with linespoints pt 9 lc rgb "#588157" title "forward dynamics", \
     data using 1:6 every ::1 with linespoints pt 13 lc rgb "#7a5195" title "Coriolis matrix"
unset multiplot
