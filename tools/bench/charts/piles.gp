# Piles.

eval begin("piles", 1200, 560)
set multiplot layout 1,2 title "Settled piles, kept awake, on one core" font font.",16" margins 0.07,0.98,0.11,0.86 spacing 0.08,0
set border 3 lc rgb "#555555"
set grid back ls 20
set logscale xy
set xrange [8:7000]; set xtics nomirror (10, 30, 100, 300, 1000, 2000, 5000)
set xlabel "balls"
piles = tables."/piles.tsv"
pile(method, setting, c) = strcol(1) eq method && strcol(2) eq setting ? column(c) : NaN
set format "%g"
set key default; set key top left samplen 2 spacing 1.3 Left reverse width -2
heaps(c) = sprintf("piles using 3:(pile('steps','60 Hz',%d)) with linespoints ls 3 title 'steps, 60 Hz',", c). \
    sprintf("piles using 3:(pile('steps','240 Hz',%d)) with linespoints ls 3 pt 6 ps 1.1 dt 2 title 'steps, 240 Hz',", c). \
    sprintf("piles using 3:(pile('Box2D','8 iterations',%d)) with linespoints ls 5 title 'Box2D, 8 iterations',", c). \
    sprintf("piles using 3:(pile('Box2D','32 iterations',%d)) with linespoints ls 5 pt 4 dt 2 title 'Box2D, 32 iterations',", c). \
    sprintf("piles using 3:(pile('Chipmunk','10 iterations',%d)) with linespoints ls 6 title 'Chipmunk, 10 iterations',", c). \
    sprintf("piles using 3:(pile('Chipmunk','40 iterations',%d)) with linespoints ls 6 pt 8 dt 2 title 'Chipmunk, 40 iterations'", c)
set title "processor time for a frame of 1/60 s"
set ylabel "ms"
set yrange [0.003:300]; set ytics nomirror autofreq
set arrow 3 from graph 0, first 16.67 to graph 1, first 16.67 nohead dt 3 lc rgb "#888888"
set label 3 "all of a frame" at graph 0.7, first 16.67 right offset 0,0.6 textcolor rgb "#777777"
eval "plot ".heaps(4)
unset arrow 3; unset label 3; unset key
set title "deepest overlap"
set ylabel "radii"
set yrange [0.001:1]; set ytics nomirror (0.001, 0.01, 0.1, 1)
eval "plot ".heaps(5)
unset multiplot
unset output
