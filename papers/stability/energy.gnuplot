# energy_error.svg from energy_error.csv (20 seeds) and long_run.csv (one run): gnuplot energy.gnuplot
set terminal svg size 800,520 font "sans,13"
set output "energy_error.svg"
set datafile separator ","
set datafile commentschars "#"
set logscale xy
set format xy "10^{%L}"
set xlabel "collisions n"
set ylabel "relative error of the energy"
set xrange [5e2:2e9]
set yrange [1e-16:1e-11]
set key top left
set grid
unit = 2.0**-53
of(scene) = sprintf("< grep '^%s' energy_error.csv", scene)
plot of("five_balls") using 2:5 with linespoints pt 7 title "5 disks, root mean square of 20 seeds", \
     of("thousand_disks") using 2:5 with linespoints pt 9 title "1000 disks, root mean square of 20 seeds", \
     "long_run.csv" using 1:(abs($2)) skip 1 with points pt 6 title "5 disks, one run, |error|", \
     unit * sqrt(x / 5.0) with lines dt 2 title "2^{-53} sqrt(n / 5)", \
     unit * sqrt(x / 1000.0) / sqrt(1000.0) with lines dt 3 title "2^{-53} sqrt(n) / 1000", \
     5e-12 with lines dt 4 title "bound, 5 10^{-12}"
