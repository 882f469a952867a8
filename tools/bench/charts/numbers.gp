# Cost against how much there is: balls, surfaces, chords in place of an arc.

numbers = tables."/numbers.tsv"
crossings = tables."/crossings.tsv"
compared = "exact steps Box2D Chipmunk"
eval begin("numbers", 1300, 900)
set multiplot layout 2,2 title "What more of everything costs" font font.",16" margins 0.075,0.98,0.14,0.9 spacing 0.085,0.13
set logscale xy
unset key
set ytics ("1 µs" 1, "10 µs" 10, "0.1 ms" 100, "1 ms" 1e3, "10 ms" 1e4, "0.1 s" 1e5, "1 s" 1e6, "10 s" 1e7)
cost(what, method) = is(what, method) && $3 > 0 ? $4 / 1e3 : NaN
# Under steps lone balls cost the same as under exact, but for noise: where that crosses is nothing to show.
shown(what, method) = strcol(1) eq what && place(method, "Box2D Chipmunk") > 0
# Where the exact method and another cost the same: a ring, with the count beside it.
plots(what) = sprintf("plot for [m in compared] numbers using 3:(cost('%s', m)) with linespoints ls style_of(m), \
    crossings using (shown('%s', strcol(2)) ? $3 : NaN):($4 / 1e3) with points pt 6 ps 3 lw 2 lc rgb '#333333', \
    crossings using (shown('%s', strcol(2)) && strcol(2) ne 'steps' ? $3 : NaN):($4 / 1e3):(sprintf('%%.0f', $3)) with labels left offset 1.3,-0.9 tc rgb '#333333', \
    crossings using (shown('%s', strcol(2)) && strcol(2) eq 'steps' ? $3 : NaN):($4 / 1e3):(sprintf('%%.0f', $3)) with labels right offset -1.3,0.9 tc rgb '#333333'", what, what, what, what)

set title "balls that fly about in a box, without gravity" font font.",13" offset 0,-0.5
set xlabel "balls" offset 0,0.3
set ylabel "processor time for a simulated second"
set xrange [0.8:700]; set yrange [0.2:2e6]
set xtics (1, 2, 5, 10, 20, 50, 100, 200, 500)
eval plots("balls")

set title "surfaces that a flying ball never reaches"
set xlabel "surfaces"
unset ylabel
set xrange [8:13000]; set yrange [0.2:2e6]
set xtics ("10" 10, "100" 100, "1000" 1000, "10 000" 10000)
eval plots("surfaces")

set title "a valley drawn as chords"
set xlabel "chords in place of the arc"
set ylabel "processor time for a simulated second"
set xrange [24:2800]; set yrange [1:2e6]
set xtics (32, 64, 128, 256, 512, 1024, 2048)
stats numbers using (is("chords", "exact") && $3 == 0 ? $4 / 1e3 : NaN) nooutput name "arc"
set arrow 1 from 24, arc_mean to 2800, arc_mean nohead lw 1.5 dt 2 lc rgb "#00796b"
set label 1 "exact on the arc itself" at 2600, arc_mean right offset 0,-0.7 tc rgb "#00796b"
eval plots("chords")
unset arrow 1; unset label 1

set title "how far chords lead away from the arc (exact method)"
set xrange [24:2800]; set yrange [1e-5:10]
set xtics (32, 128, 512, 2048)
set ylabel "error against the true arc"
set ytics ("0.01 mm" 1e-5, "0.1 mm" 1e-4, "1 mm" 1e-3, "1 cm" 1e-2, "10 cm" 0.1, "1 m" 1, "10 m" 10)
strayed(scene) = is(scene, "exact on pieces") ? $6 : NaN
pieces(dummy) = strcol(2) eq "exact on pieces" ? real(word(strcol(3), 1)) : NaN
set key bottom left samplen 3 spacing 1.3 Left reverse
plot results using (pieces(0)):(strayed("valley")) with linespoints ls 1 title "valley", \
    results using (pieces(0)):(strayed("hill")) with linespoints ls 1 dt 2 pt 12 title "hill", \
    results using (pieces(0)):(strayed("loop")) with linespoints ls 1 dt 3 pt 6 title "loop"

unset title; unset border; unset tics; unset grid; unset xlabel; unset ylabel
set lmargin at screen 0.05; set rmargin at screen 0.98; set bmargin at screen 0.005; set tmargin at screen 0.06
set key center center horizontal samplen 3 width 2 Left reverse font font.",12"
unset logscale xy; set xrange [0:1]; set yrange [0:1]
plot NaN with linespoints ls 1 title "exact", NaN with linespoints ls 3 title "steps, 240 Hz", NaN with linespoints ls 5 title "Box2D, 60 Hz", \
    NaN with linespoints ls 6 title "Chipmunk, 60 Hz", NaN with points pt 6 ps 3 lw 2 lc rgb "#333333" title "beyond it exact costs more"
unset multiplot
unset output
