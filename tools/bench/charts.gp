# Draws the tables of smb2d_bench: gnuplot -e "tables='FOLDER'; charts='FOLDER'; kind='svg'" charts.gp (or kind='png')

set encoding utf8
set datafile separator "\t"
font = "DejaVu Sans"
# A picture of this size in pixels, NAME.svg or NAME.png.
begin(name, width, height) = kind eq "svg" ? \
    sprintf("set terminal svg size %d,%d dynamic background '#ffffff' font '%s,13'; set output '%s/%s.svg'", \
            width, height, font, charts, name) : \
    sprintf("set terminal pngcairo size %d,%d background '#ffffff' font '%s,10'; set output '%s/%s.png'", \
            width, height, font, charts, name)

set style line 1 lc rgb "#00796b" lw 2.5 pt 13 ps 1.5   # exact
set style line 2 lc rgb "#80cbc4" lw 1.5 pt 12 ps 1.0   # exact on pieces
set style line 3 lc rgb "#1e66c8" lw 2.5 pt 7  ps 0.9   # steps
set style line 4 lc rgb "#9e9e9e" lw 1.5 pt 7  ps 0.7   # article
set style line 5 lc rgb "#e08214" lw 2.0 pt 5  ps 0.9   # Box2D
set style line 6 lc rgb "#c2185b" lw 2.0 pt 9  ps 1.0   # Chipmunk
set style line 7 lc rgb "#e08214" lw 1.5 dt 2 pt 4 ps 0.9   # Box2D on finer pieces
set style line 8 lc rgb "#c2185b" lw 1.5 dt 2 pt 8 ps 1.0   # Chipmunk on finer pieces
set border 3 lc rgb "#555555"
set tics nomirror textcolor rgb "#333333"
set style line 20 lc rgb "#e6e6e6" lw 1
set grid back ls 20

results = tables."/results.tsv"
scenes = "ramp skid slide bounce valley hill loop drag-soft drag-stiff flat wall pair row"
title_of(scene) = scene eq "ramp" ? "rolling down a ramp, 10 s" : \
    scene eq "skid" ? "a skid that ends in rolling, 10 s" : scene eq "slide" ? "sliding, too steep to grip, 10 s" : \
    scene eq "bounce" ? "bouncing to rest, 8 s" : scene eq "valley" ? "to and fro in a round valley, 20 s" : \
    scene eq "hill" ? "off a hill into the air, 1.75 s" : scene eq "loop" ? "inside a loop, 5 s" : \
    scene eq "drag-soft" ? "dragged by a soft spring, 4 s" : scene eq "drag-stiff" ? "dragged by a stiff spring, 4 s" : \
    scene eq "flat" ? "over 200 flat pieces, 8 s" : scene eq "wall" ? "10 km/s against a thin wall, 0.1 s" : \
    scene eq "pair" ? "one ball hits another, 0.5 s" : "a ball hits a row of five, 1 s"

pixel = 16.0 / 1280
failed = 3e4   # where failures stand, m
is(scene, method) = strcol(1) eq scene && strcol(2) eq method
error(scene, method) = is(scene, method) ? column(6) : NaN
high(scene, method) = is(scene, method) ? (strcol(7) eq "nan" ? failed : column(7)) : NaN
lost(scene, method) = is(scene, method) && strcol(6) eq "nan" ? failed : NaN
cost(c) = column(c) / 1000

# (a) Work against precision, scene by scene.
set macros
axes = 'set logscale xy; set xrange [1e-16:1e5]; set yrange [0.04:4e6]; \
    set xtics ("10^{-16}" 1e-16, "10^{-12}" 1e-12, "10^{-8}" 1e-8, "10^{-4}" 1e-4, "1 m" 1, "failed" failed); \
    set ytics ("0.1 µs" 0.1, "1 µs" 1, "10 µs" 10, "0.1 ms" 100, "1 ms" 1e3, "10 ms" 1e4, "0.1 s" 1e5, "1 s" 1e6); \
    set arrow 1 from pixel, graph 0 to pixel, graph 1 nohead dt 3 lc rgb "#888888"; \
    set arrow 2 from graph 0, first 1e6 to graph 1, first 1e6 nohead dt 3 lc rgb "#888888"; \
    set label 1 "one pixel" at pixel, graph 0.03 left rotate offset -0.5,0 textcolor rgb "#777777"; \
    set label 2 "all of the time there is" at graph 0.02, first 1e6 left offset 0,0.6 textcolor rgb "#777777"'
curve(i, method) = sprintf("results using (error(scene,'%s')):(cost(9)):(error(scene,'%s')):(high(scene,'%s')) \
    with xerrorlines ls %d title '%s', results using (lost(scene,'%s')):(cost(9)) with points lc rgb colour(%d) pt 2 ps 1.2 lw 2 notitle", \
    method, method, method, i, method eq "exact" ? "exact, asked 60 times a second" : method, method, i)
advised(i, method) = sprintf("results using (column(5) == 1 ? error(scene,'%s') : NaN):(cost(9)) with points lc rgb colour(%d) pt 6 ps 2.4 lw 1.2 notitle", method, i)
colour(i) = word("#00796b #80cbc4 #1e66c8 #9e9e9e #e08214 #c2185b #e08214 #c2185b", i)
round(scene) = scene eq "valley" || scene eq "hill" || scene eq "loop"
hollow(scene) = scene eq "valley" || scene eq "loop"
curves(scene) = (hollow(scene) ? curve(8, "Chipmunk on finer pieces").",".curve(7, "Box2D on finer pieces")."," : ""). \
    (round(scene) ? curve(2, "exact on pieces")."," : "").curve(6, "Chipmunk").",".curve(5, "Box2D").",".curve(4, "article").",". \
    curve(3, "steps").",".curve(1, "exact"). \
    ",results using (error(scene,'exact')):(cost(10)) with points lc rgb '#00796b' pt 12 ps 1.5 lw 2 title 'exact, asked once'". \
    ",".advised(5, "Box2D").",".advised(6, "Chipmunk")

set xlabel "largest error of the run: median of the starts, with a bar to the 95th percentile"
set ylabel "processor time for a simulated second"
do for [i = 1:words(scenes)] {
    scene = word(scenes, i)
    eval begin("work-".scene, 900, 620)
    eval axes
    set title title_of(scene) font font.",15"
    set key outside right top samplen 2 spacing 1.3 Left reverse invert
    eval "plot ".curves(scene).", NaN with points pt 6 ps 2.4 lc rgb '#333333' title 'as its makers advise', NaN with points pt 2 lw 2 lc rgb '#333333' title 'failed'"
    unset output
}

eval begin("work-precision", 1500, 1130)
set multiplot layout 4,4 title "Speed against accuracy: further left is more accurate, further down is faster" font font.",18" \
    margins 0.05,0.985,0.04,0.92 spacing 0.05,0.065
eval axes
set format y ""
unset xlabel; unset ylabel
unset label 2; unset label 1
set xtics ("10^{-16}" 1e-16, "10^{-8}" 1e-8, "1 m" 1, "failed" failed)
set ytics ("1 µs" 1, "1 ms" 1e3, "1 s" 1e6)
unset key
do for [i = 1:words(scenes)] {
    scene = word(scenes, i)
    set title title_of(scene) font font.",11" offset 0,-0.6
    eval "plot ".curves(scene)
}
unset title; unset border; unset tics; unset arrow; unset grid
set lmargin at screen 0.3; set rmargin at screen 0.95; set bmargin at screen 0.04; set tmargin at screen 0.22
set key center center samplen 3 spacing 1.6 font font.",12" Left reverse noinvert maxrows 6
unset logscale xy; set yrange [0:1]; set xrange [0:1]
plot NaN with linespoints ls 1 title "exact, asked 60 times a second", \
    NaN with points lc rgb "#00796b" pt 12 ps 1.5 lw 2 title "exact, asked once", \
    NaN with linespoints ls 2 title "exact on 32 to 2048 chords", NaN with linespoints ls 3 title "steps, 60 to 7680 Hz", \
    NaN with linespoints ls 4 title "article, 60 to 7680 Hz", NaN with linespoints ls 5 title "Box2D, 60 to 7680 Hz", \
    NaN with linespoints ls 6 title "Chipmunk, 60 to 7680 Hz", \
    NaN with linespoints ls 7 title "the two on 2048 chords to an arc, not 512", NaN with points pt 2 lc rgb "#333333" lw 2 title "failed", \
    NaN with points pt 6 ps 2.4 lc rgb "#333333" title "as its makers advise", \
    NaN with lines dt 3 lc rgb "#888888" title "one pixel; all of the time there is"
unset multiplot
unset output
unset lmargin; unset rmargin; unset bmargin; unset tmargin

# (b) The cheapest way to an accuracy, scene by method.
methods = "exact steps article Box2D Chipmunk"
place(name, list) = sum [k = 1:words(list)] (word(list, k) eq name ? k : 0)
x_of(dummy) = place(strcol(2), methods)
y_of(dummy) = -place(strcol(1), scenes)
said(c) = strcol(c) eq "never" ? "never" : column(c) < 1e3 ? sprintf("%.0f ns", column(c)) : \
    column(c) < 1e4 ? sprintf("%.1f µs", column(c) / 1e3) : column(c) < 1e6 ? sprintf("%.0f µs", column(c) / 1e3) : \
    sprintf("%.1f ms", column(c) / 1e6)
accuracy(c) = (c == 3) ? "to one pixel, 12.5 mm" : (c == 4) ? "to a micrometre" : "to a tenth of a nanometre"
eval begin("reach", 1300, 620)
reach = tables."/reach.tsv"
set multiplot layout 1,3 title "What it costs to be this accurate: processor time for a simulated second, asked 60 times" \
    font font.",16" margins 0.08,0.985,0.04,0.84 spacing 0.015,0
set border 0; unset key; unset colorbox; unset grid
set xrange [0.5:5.5]; set yrange [-13.5:-0.5]
set palette defined (0 "#1b9e77", 1.2 "#a6dba0", 2.2 "#fff3b0", 3.2 "#f7a35c", 4.3 "#d6604d")
set cbrange [3:7.3]
set xtics scale 0 ("exact" 1, "steps" 2, "article" 3, "Box2D" 4, "Chipmunk" 5) offset 0,0
unset ytics
unset xtics
set x2range [0.5:5.5]
set x2tics scale 0 ("exact" 1, "steps" 2, "article" 3, "Box2D" 4, "Chipmunk" 5) offset 0,-0.5
do for [c = 3:5] {
    set title accuracy(c) font font.",13"
    if (c == 3) { set ytics scale 0; do for [k = 1:words(scenes)] { set ytics add (word(scenes, k) -k) } } \
    else { unset ytics }
    plot reach using (x_of(0)):(y_of(0)):(x_of(0)-0.47):(x_of(0)+0.47):(y_of(0)-0.45):(y_of(0)+0.45):(strcol(c) eq "never" ? NaN : log10(column(c))) \
            axes x2y1 with boxxyerror fs solid 1 noborder lc palette, \
        reach using (strcol(c) eq "never" ? x_of(0) : NaN):(y_of(0)):(x_of(0)-0.47):(x_of(0)+0.47):(y_of(0)-0.45):(y_of(0)+0.45) \
            axes x2y1 with boxxyerror fs solid 1 noborder lc rgb "#eeeeee", \
        reach using (strcol(c) eq "never" ? NaN : x_of(0)):(y_of(0)):(said(c)) axes x2y1 with labels textcolor rgb "#1a1a1a", \
        reach using (strcol(c) eq "never" ? x_of(0) : NaN):(y_of(0)):(said(c)) axes x2y1 with labels textcolor rgb "#a0a0a0"
}
unset multiplot
unset output

# (e) Where a drag spring stays stable at 60 steps a second.
eval begin("drag-stability", 1300, 760)
unset x2tics; unset xtics; unset ytics; unset title
set multiplot layout 2,3 title "The drag spring at 60 steps a second: how far the answer to a sudden pull is off, and where the ball runs away" \
    font font.",16" margins 0.06,0.88,0.09,0.88 spacing 0.03,0.1
set border 15 lc rgb "#555555"
set xrange [log10(0.5):log10(60)]; set yrange [0:2]
set xtics scale 0.5 nomirror ("0.5" log10(0.5), "1" 0, "2" log10(2), "5" log10(5), "10" 1, "20" log10(20), "50" log10(50))
set ytics scale 0.5 nomirror 0.5
set palette defined (-15 "#1a5276", -11 "#2e86c1", -6 "#a9dfbf", -2 "#f9e79f", -1 "#f5b041", 0 "#dc7633", 0.45 "#cb4335", 0.46 "#2b2b2b", 1 "#2b2b2b")
set cbrange [-15:1]
set format "%g"
drag = tables."/drag.tsv"
names = "symplectic_Euler exact steps article Box2D Chipmunk"
bound(z) = log10(60 / pi * (sqrt(1 + z * z) - z))
set samples 200
do for [i = 0:5] {
    unset colorbox
    if (i == 2) { set colorbox user origin 0.905,0.09 size 0.018,0.79; \
        set cbtics scale 0 ("10^{-15}" -15, "10^{-12}" -12, "10^{-9}" -9, "10^{-6}" -6, "10^{-3}" -3, "all" 0, "runs away" 0.75) }
    name = word(names, i + 1)
    set title name eq "symplectic_Euler" ? "symplectic Euler, the plain loop" : name font font.",13" offset 0,-0.5
    set xlabel i > 2 ? "frequency of the spring, Hz" : "" offset 0,0.3
    set ylabel i % 3 == 0 ? "damping, of critical" : ""
    plot drag index i using (log10($2)):3:($5 == 1 ? log10($4 < 1e-15 ? 1e-15 : $4 > 2.5 ? 2.5 : $4) : 1) with image notitle, \
        "+" using (bound(2 * ($1 - log10(0.5)) / (log10(60) - log10(0.5)))):(2 * ($1 - log10(0.5)) / (log10(60) - log10(0.5))) \
            with lines lw 2 dt 2 lc rgb "#ffffff" notitle
}
unset multiplot
unset output

# (e) Which walls hold at 60 steps a second.
eval begin("walls", 1300, 420)
set multiplot layout 1,5 title "A ball of radius 0.5 m thrown at a wall, 60 steps a second: how many get through" \
    font font.",16" margins 0.06,0.98,0.16,0.78 spacing 0.02,0
unset colorbox
set palette defined (0 "#d4e6f1", 0.001 "#f5b041", 0.5 "#cb4335", 1 "#2b2b2b")
set cbrange [0:1]
set xrange [0:5]; set yrange [0:2]
set xtics scale 0.5 nomirror ("1" 0, "10" 1, "100" 2, "1000" 3, "10^4" 4)
walls = tables."/walls.tsv"
names = "exact steps article Box2D Chipmunk"
step_past = log10(60 * 0.5)  # a radius a step, m/s
do for [i = 0:4] {
    set title word(names, i + 1) font font.",13" offset 0,-0.5
    set xlabel "speed, m/s" offset 0,0.3
    set ylabel i == 0 ? "thickness of the wall, m" : ""
    if (i > 0) { set ytics scale 0.5 ("" 0, "" 0.5, "" 1, "" 1.5, "" 2) } else { set ytics scale 0.5 nomirror autofreq 0.5 }
    plot walls index i using (log10($2)):3:4 with image notitle, \
        "+" using (step_past):($1 * 2 / 5) with lines lw 2 dt 2 lc rgb "#7f8c8d" notitle
}
unset multiplot
unset output

# (f) Piles.
eval begin("piles", 1200, 560)
unset colorbox; unset title; unset xtics; unset ytics
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

# (f) Surfaces: arcs that are drawn as chords.
eval begin("surfaces", 1200, 560)
set multiplot layout 1,2 title "The exact method where a curve is drawn as straight pieces" font font.",16" \
    margins 0.08,0.98,0.11,0.86 spacing 0.09,0
chords(scene, c) = is(scene, "exact on pieces") ? column(c) : NaN
is_chords(dummy) = strcol(2) eq "exact on pieces"
count(dummy) = real(word(strcol(3), 1))
set xrange [24:2800]; set xtics nomirror (32, 128, 512, 2048)
set xlabel "straight pieces in place of the arc"
set key default; set key top left samplen 2 spacing 1.3 Left reverse width -2
set title "processor time for a simulated second"
set ylabel ""
set yrange [1:3e5]
set ytics nomirror ("1 µs" 1, "10 µs" 10, "0.1 ms" 100, "1 ms" 1e3, "10 ms" 1e4, "0.1 s" 1e5)
plot results using (is_chords(0) ? count(0) : NaN):(chords("valley", 9) / 1e3) with linespoints ls 1 title "valley", \
    results using (is_chords(0) ? count(0) : NaN):(chords("hill", 9) / 1e3) with linespoints ls 3 title "hill", \
    results using (is_chords(0) ? count(0) : NaN):(chords("loop", 9) / 1e3) with linespoints ls 5 title "loop"
set title "error against the true arc"
unset key
set yrange [1e-5:10]
set ytics nomirror ("0.01 mm" 1e-5, "0.1 mm" 1e-4, "1 mm" 1e-3, "1 cm" 1e-2, "10 cm" 0.1, "1 m" 1, "10 m" 10)
plot results using (is_chords(0) ? count(0) : NaN):(chords("valley", 6)) with linespoints ls 1, \
    results using (is_chords(0) ? count(0) : NaN):(chords("hill", 6)) with linespoints ls 3, \
    results using (is_chords(0) ? count(0) : NaN):(chords("loop", 6)) with linespoints ls 5
unset multiplot
unset output
