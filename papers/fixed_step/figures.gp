# Figures from the CSV files beside this file, which run.sh writes.
set terminal svg size 760,420 font "sans-serif,12" noenhanced
set datafile separator ','
set datafile missing NaN
set key outside right top reverse Left samplen 2
set grid lc rgb "#dddddd"
pick(name, value) = stringcolumn(1) eq name ? value : NaN

# Colours of the methods and engines, the same in all figures.
set style line 1 lc rgb "#1f77b4" lw 1.5 pt 7 ps 0.6
set style line 2 lc rgb "#ff7f0e" lw 1.5 pt 5 ps 0.6
set style line 3 lc rgb "#2ca02c" lw 1.5 pt 9 ps 0.7
set style line 4 lc rgb "#d62728" lw 1.5 pt 11 ps 0.7
set style line 5 lc rgb "#9467bd" lw 1.5 pt 13 ps 0.8
set style line 6 lc rgb "#8c564b" lw 1.5 pt 4 ps 0.7
set style line 7 lc rgb "#e377c2" lw 1.5 pt 6 ps 0.7
set style line 8 lc rgb "#555555" lw 1.5 pt 8 ps 0.7

set output 'miss.svg'
set xlabel '|v| dt / s'
set ylabel 'share of phases'
set xrange [0:9]; set yrange [-0.02:1]
chord(b) = 2 * sqrt(1 - b * b)
miss(c, x) = x > c ? 1 - c / x : 0
share(b, kind) = stringcolumn(1) eq "discrete" && abs($2 - b) < 1e-9 && stringcolumn(4) eq kind ? $5 : NaN
set samples 150
plot for [k=0:2] b = (k == 0 ? 0.0 : k == 1 ? 0.5 : 0.9) miss(chord(b), x) ls k + 1 dt 2 t sprintf("1 - chord/step, b = %.1f", b), \
     for [k=0:2] b = (k == 0 ? 0.0 : k == 1 ? 0.5 : 0.9) miss(chord(b) / 2, x) ls k + 1 t sprintf("1 - chord/2 step, b = %.1f", b), \
     for [k=0:2] 'miss.csv' using 3:(share((k == 0 ? 0.0 : k == 1 ? 0.5 : 0.9), "unseen")):6 with yerrorbars ls k + 1 pt 6 notitle, \
     for [k=0:2] 'miss.csv' using 3:(share((k == 0 ? 0.0 : k == 1 ? 0.5 : 0.9), "no impulse")):6 with yerrorbars ls k + 1 notitle

set output 'plate.svg'
set xlabel '|v_n| dt / (w + 2 a)'
set xrange [0:3.2]; set yrange [-0.02:1]
plate(name, w, kind) = stringcolumn(1) eq name && abs($2 - w) < 1e-9 && stringcolumn(4) eq kind ? $5 : NaN
plot miss(1, x) ls 1 dt 2 t '1 - (w + 2 a)/step', \
     miss(0.5, x) ls 1 t '1 - a/step, w = 0', \
     miss(0.9 / 1.4, x) ls 2 t '1 - (a + w)/step, w = 0.8 a', \
     'plate.csv' using ($3 / (1 + $2)):(plate("discrete", 0, "unseen")):6 with yerrorbars ls 1 pt 6 t 'discrete, w = 0: unseen', \
     '' using ($3 / (1 + $2)):(plate("discrete", 0.4, "unseen")):6 with yerrorbars ls 2 pt 6 t 'w = 0.8 a: unseen', \
     '' using ($3 / (1 + $2)):(plate("discrete", 0, "no impulse")):6 with yerrorbars ls 1 t 'w = 0: through', \
     '' using ($3 / (1 + $2)):(plate("discrete", 0.4, "no impulse")):6 with yerrorbars ls 2 t 'w = 0.8 a: through', \
     '' using ($3 / (1 + $2)):(plate("swept", 0, "no impulse")) ls 3 t 'swept: through', \
     '' using ($3 / (1 + $2)):(plate("box2d", 0, "no impulse")) ls 6 t 'box2d: through', \
     '' using ($3 / (1 + $2)):(plate("chipmunk", 0, "no impulse")) ls 7 t 'chipmunk: through', \
     '' using ($3 / (1 + $2)):(plate("bullet:continuous", 0, "no impulse")) ls 8 t 'bullet:continuous'

set output 'drop.svg'
set xlabel 'bounce'
set ylabel 'energy at the top / (m g h), dt = 1/240'
set xrange [0:21]; set yrange [0:1.3]
drop(name) = stringcolumn(1) eq name && abs($2 - 1 / 240.) < 1e-9 ? $5 : NaN
plot 1 lc rgb "black" t 'exact', \
     'drop.csv' using 3:(drop("discrete")) with linespoints ls 1 t 'discrete', \
     '' using 3:(drop("discrete:correction=none")) with linespoints ls 2 t 'discrete:correction=none', \
     '' using 3:(drop("swept")) with linespoints ls 3 t 'swept', \
     '' using 3:(drop("speculative")) with linespoints ls 4 t 'speculative', \
     '' using 3:(drop("penalty")) with linespoints ls 5 t 'penalty', \
     '' using 3:(drop("box2d")) with linespoints ls 6 t 'box2d', \
     '' using 3:(drop("chipmunk")) with linespoints ls 7 t 'chipmunk', \
     '' using 3:(drop("bullet")) with linespoints ls 8 t 'bullet'

own = "discrete swept swept:substeps speculative penalty box2d chipmunk bullet"
colour(k) = k == 1 ? 1 : k == 2 ? 3 : k == 3 ? 2 : k + 0
set logscale xy
set format x '%.0e'; set format y '%.0e'

set output 'break_shot.svg'
set xlabel 'dt [s]'
set ylabel 'position error at the 20th collision [m]'
set xrange [*:*]; set yrange [*:*]
plot for [k=1:8] 'break_shot.csv' using 2:(pick(word(own, k), $8)) with linespoints ls colour(k) t word(own, k)

set output 'work_precision.svg'
set xlabel 'time of the run / time of the exact run'
set ylabel 'position error at 0.03, the largest of 1000'
rounding = real(system("awk -F, '$1 == \"exact\" { print $8 }' gas.csv"))
set arrow 1 from graph 0, first rounding to graph 1, first rounding nohead lc rgb "black" dt 3
plot for [k=1:8] 'gas.csv' using 9:(pick(word(own, k), $8)) with linespoints ls colour(k) t word(own, k), \
     'gas.csv' using 9:(pick("exact", $8)) with points pt 3 ps 1.5 lc rgb "black" t 'exact'
unset arrow 1

set output 'pressure.svg'
set xlabel 'dt'
set ylabel '|pressure / exact - 1|'
plot for [k=1:8] 'gas.csv' using 2:(pick(word(own, k), abs($5))):6 with yerrorbars ls colour(k) notitle, \
     for [k=1:8] 'gas.csv' using 2:(pick(word(own, k), abs($5))) with lines ls colour(k) t word(own, k)
