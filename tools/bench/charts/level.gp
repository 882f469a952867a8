# A level of the user's own: error against cost. Wants `name`, of the picture.

about = tables."/level_reference.tsv"
level = tables."/level.tsv"
set xrange [-1:1]; set yrange [-1:1]
set table $nothing
plot about using (title = strcol(1), said = strcol(2), known = column(3), seconds = column(4), 0)
unset table
failed = 3e4
least = 1e-16
error(method) = strcol(1) eq method && strcol(4) ne "nan" ? (column(4) < 2 * least ? 2 * least : column(4)) : NaN
lost(method) = strcol(1) eq method && strcol(4) eq "nan" ? failed : NaN
known = known < 2 * least ? 2 * least : known > failed ? failed : known
eval begin(name, 1000, 640)
set title sprintf("%s, %g s\nreference: %s", title, seconds, said) font font.",12" noenhanced
set logscale xy; set autoscale y
set xrange [least:1e5]
set xtics ("10^{-16}" 1e-16, "10^{-12}" 1e-12, "10^{-8}" 1e-8, "10^{-4}" 1e-4, "1 m" 1, "failed" failed)
set ytics ("0.1 µs" 0.1, "1 µs" 1, "10 µs" 10, "0.1 ms" 100, "1 ms" 1e3, "10 ms" 1e4, "0.1 s" 1e5, "1 s" 1e6, "10 s" 1e7)
set offsets graph 0, graph 0, graph 0.1, graph 0.1
set xlabel "largest error of the run"
set ylabel "processor time for a simulated second"
pixel = 16.0 / 1280
set arrow 1 from pixel, graph 0 to pixel, graph 1 nohead dt 3 lc rgb "#888888"
set label 1 "one pixel" at pixel, graph 0.03 left rotate offset -0.5,0 tc rgb "#777777"
set object 1 rectangle from least, graph 0 to known, graph 1 fs solid 0.5 noborder fc rgb "#f1f1f1" behind
set key outside right top samplen 2 spacing 1.3 Left reverse
plot for [m in "article euler steps exact"] level using (error(m)):($5 / 1e3) with linespoints ls style_of(m) notitle, \
    for [m in "article euler steps exact"] level using (lost(m)):($5 / 1e3) with points lc rgb colour(style_of(m)) pt 2 ps 1.2 lw 2 notitle, \
    level using (error("exact")):($6 / 1e3) with points lc rgb "#00796b" pt 12 ps 1.5 lw 2 notitle, \
    NaN with linespoints ls 1 title "exact, asked 60 times", NaN with points lc rgb "#00796b" pt 12 ps 1.5 lw 2 title "exact, asked once", \
    NaN with linespoints ls 3 title "steps, 60 to 7680 Hz", NaN with linespoints ls 9 title "euler, 60 to 7680 Hz", \
    NaN with linespoints ls 4 title "article, 60 to 7680 Hz", \
    NaN with points pt 2 lw 2 lc rgb "#333333" title "failed", \
    NaN with boxes fs solid 1 noborder fc rgb "#e8e8e8" title "finer than is known"
unset output
