# Work against precision, scene by scene: one chart each, and all together.

front = tables."/front.tsv"
pixel = 16.0 / 1280
failed = 3e4   # where failures stand, m
error(scene, method) = is(scene, method) ? column(6) : NaN
high(scene, method) = is(scene, method) ? (strcol(7) eq "nan" ? failed : column(7)) : NaN
lost(scene, method) = is(scene, method) && strcol(6) eq "nan" ? failed : NaN
cost(c) = column(c) / 1000
of(engine) = strcol(2) eq engine || strcol(2) eq engine." on finer pieces"

axes = 'set logscale xy; set xrange [1e-16:1e5]; set yrange [0.04:4e6]; \
    set xtics ("10^{-16}" 1e-16, "10^{-12}" 1e-12, "10^{-8}" 1e-8, "10^{-4}" 1e-4, "1 m" 1, "failed" failed); \
    set ytics ("0.1 µs" 0.1, "1 µs" 1, "10 µs" 10, "0.1 ms" 100, "1 ms" 1e3, "10 ms" 1e4, "0.1 s" 1e5, "1 s" 1e6); \
    set arrow 1 from pixel, graph 0 to pixel, graph 1 nohead dt 3 lc rgb "#888888"; \
    set arrow 2 from graph 0, first 1e6 to graph 1, first 1e6 nohead dt 3 lc rgb "#888888"; \
    set label 1 "one pixel" at pixel, graph 0.03 left rotate offset -0.5,0 textcolor rgb "#777777"; \
    set label 2 "all of the time there is, at 60 Hz" at graph 0.99, first 1e6 right offset 0,0.6 textcolor rgb "#777777"'
# The staircase that nobody gets below or left of.
stairs = "front using (strcol(1) eq scene ? $4 : NaN):(cost(5)) with steps lw 7 lc rgb '#ffe082' notitle"
curve(i, method) = sprintf("results using (error(scene,'%s')):(cost(9)):(error(scene,'%s')):(high(scene,'%s')) \
    with xerrorlines ls %d notitle, results using (lost(scene,'%s')):(cost(9)) with points lc rgb colour(%d) pt 2 ps 1.2 lw 2 notitle", \
    method, method, method, i, method, i)
advised(i, method) = sprintf("results using (column(5) == 1 ? error(scene,'%s') : NaN):(cost(9)) \
    with points lc rgb colour(%d) pt 6 ps 2.4 lw 1.2 notitle", method, i)
best(i, method) = sprintf("results using (strcol(1) eq scene && of('%s') && column(11) == 1 ? column(6) : NaN):(cost(9)) \
    with points lc rgb colour(%d) pt 4 ps 2.6 lw 1.2 notitle", method, i)
round(scene) = scene eq "valley" || scene eq "hill" || scene eq "loop"
hollow(scene) = scene eq "valley" || scene eq "loop"
curves(scene) = stairs.",".(hollow(scene) ? curve(8, "Chipmunk on finer pieces").",".curve(7, "Box2D on finer pieces")."," : ""). \
    (round(scene) ? curve(2, "exact on pieces")."," : "").curve(6, "Chipmunk").",".curve(5, "Box2D").",".curve(4, "article").",". \
    curve(9, "euler").",". \
    curve(3, "steps").",".curve(1, "exact"). \
    ",results using (error(scene,'exact')):(cost(10)) with points lc rgb '#00796b' pt 12 ps 1.5 lw 2 notitle". \
    ",".advised(5, "Box2D").",".advised(6, "Chipmunk").",".best(5, "Box2D").",".best(6, "Chipmunk")
keys = "NaN with linespoints ls 1 title 'exact, asked 60 times a second', \
    NaN with points lc rgb '#00796b' pt 12 ps 1.5 lw 2 title 'exact, asked once', \
    NaN with linespoints ls 3 title 'steps, 60 to 7680 Hz', NaN with linespoints ls 9 title 'euler, 60 to 7680 Hz', NaN with linespoints ls 4 title 'article, 60 to 7680 Hz', \
    NaN with linespoints ls 5 title 'Box2D, 60 to 7680 Hz', NaN with linespoints ls 6 title 'Chipmunk, 60 to 7680 Hz', \
    NaN with points pt 6 ps 2.4 lw 1.2 lc rgb '#333333' title 'as its makers advise', \
    NaN with points pt 4 ps 2.6 lw 1.2 lc rgb '#333333' title 'its least error', \
    NaN with points pt 2 lw 2 lc rgb '#333333' title 'failed', \
    NaN with lines lw 7 lc rgb '#ffe082' title 'the front: nobody is below or left of it'"
chords = "NaN with linespoints ls 2 title 'exact on 32 to 2048 chords'"
finer = "NaN with linespoints ls 7 title 'Box2D on 2048 chords, not 512', \
    NaN with linespoints ls 8 title 'Chipmunk on 2048 chords'"

set xlabel "largest error of the run: median of the starts, with a bar to the 95th percentile"
set ylabel "processor time for a simulated second"
do for [i = 1:words(scenes)] {
    scene = word(scenes, i)
    eval begin("work-".scene, 960, 620)
    eval axes
    set title title_of(scene) font font.",15"
    set key outside right top samplen 2 spacing 1.3 Left reverse noinvert
    eval "plot ".curves(scene).",".keys.(round(scene) ? ",".chords : "").(hollow(scene) ? ",".finer : "")
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
set lmargin at screen 0.28; set rmargin at screen 0.97; set bmargin at screen 0.03; set tmargin at screen 0.22
set key center center samplen 3 spacing 1.3 font font.",12" Left reverse noinvert maxrows 8
unset logscale xy; set yrange [0:1]; set xrange [0:1]
eval "plot ".keys.",".chords.",".finer.", NaN with lines dt 3 lc rgb '#888888' title 'one pixel; all of the time there is at 60 Hz'"
unset multiplot
unset output
