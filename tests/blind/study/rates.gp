# SPDX-License-Identifier: GPL-3.0-or-later
# gnuplot -e "data='rates.csv'" rates.gp: how often one cause in a drive is found, over its size, as SVG.
set terminal svg size 640,360 font "sans-serif,12" background "white"
set datafile separator ","
set key bottom right
set grid
set xlabel "rms of the cause over the noise's"
set ylabel "trials [%]"
set logscale x
set xrange [0.09:1.1]
set xtics (0.1, 0.2, 0.3, 0.5, 1)
set yrange [0:105]
plot data using 1:2 every ::1 with linespoints pt 7 lc rgb "#1b6ca8" title "detected", \
     data using 1:3 every ::1 with linespoints pt 5 lc rgb "#588157" title "in the set told", \
     data using 1:4 every ::1 with linespoints pt 9 lc rgb "#c8553d" title "right name first"
