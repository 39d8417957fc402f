# energy_error.svg from energy_error.csv (20 seeds) and long_run.csv (one run): gnuplot energy.gnuplot
set terminal svg size 800,560 font "sans,13"
set output "energy_error.svg"
set datafile separator ","
set datafile commentschars "#"
set logscale xy
set format xy "10^{%L}"
set xlabel "collisions n"
set ylabel "relative error of the energy"
set xrange [5e2:2e9]
set yrange [1e-18:1e-10]
set key below
set grid
walk(c, f, n) = c * sqrt(f * n)    # c: rounding_walk.py; f: share of the impacts that two balls have
of(scene) = sprintf("< grep '^%s' energy_error.csv", scene)
plot of("five_balls") using 2:5 with points pt 7 lc 1 title "5 disks, root mean square of 20 seeds", \
     walk(3.386e-17, 0.451, x) with lines lc 1 title "unbiased rounding, as sqrt(n)", \
     "long_run.csv" using 1:(abs($2)) skip 1 with points pt 6 lc 1 title "5 disks, one run, |error|", \
     of("thousand_disks") using 2:5 with points pt 9 lc 2 title "1000 disks, root mean square of 20 seeds", \
     walk(1.992e-19, 0.949, x) with lines lc 2 title "unbiased rounding, as sqrt(n)", \
     5e-12 with lines dt 2 lc 0 title "bound, 5 10^{-12}"
