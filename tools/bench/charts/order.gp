# Order of convergence: error against step.

chosen = "hill valley loop slide drag-soft pair"
orders = tables."/orders.tsv"
eval begin("order", 1300, 840)
set multiplot layout 2,3 title "How fast the error falls with the step: the number is the slope" font font.",16" \
    margins 0.07,0.985,0.16,0.88 spacing 0.045,0.12
set logscale xy
set xrange [0.02:30]; set yrange [1e-15:100]
set xtics ("0.1 ms" 0.1, "1 ms" 1, "1/60 s" 1000.0 / 60)
set ytics ("10^{-12}" 1e-12, "10^{-8}" 1e-8, "10^{-4}" 1e-4, "1 m" 1)
unset key
# What grows as steps get shorter is rounding.
slope(c) = column(c) < -0.3 ? 'rounding' : abs(column(c)) < 0.05 ? '0' : sprintf('%.1f', column(c))
step(c) = 1000.0 / column(c)
of(scene, method) = is(scene, method) ? column(6) : NaN
line(method) = sprintf("results using (step(4)):(of(scene,'%s')) with linespoints ls %d notitle, \
    orders using (is(scene,'%s') ? 1000 * $4 : NaN):5:(slope(3)) with labels right offset -1,%g tc ls %d notitle", \
    method, style_of(method), method, method eq "Box2D" ? 0.5 : method eq "Chipmunk" ? -0.5 : 0, style_of(method))
do for [i = 1:words(chosen)] {
    scene = word(chosen, i)
    set title title_of(scene) font font.",12" offset 0,-0.5
    set xlabel i > 3 ? "step" : "" offset 0,0.3
    set ylabel i % 3 == 1 ? "largest error, median" : ""
    set label 1 "h" at 0.03, 1e-6 * 0.03 center offset 0,0.7 tc rgb "#999999"
    set label 2 "h^2" at 0.06, 2e-10 * 0.06**2 center offset 0,0.7 tc rgb "#999999"
    eval "plot 1e-6 * x with lines dt 3 lw 1.5 lc rgb '#999999' notitle, 2e-10 * x**2 with lines dt 3 lw 1.5 lc rgb '#999999' notitle,". \
        line("article").",".line("Chipmunk").",".line("Box2D").",".line("euler").",".line("steps").", \
        results using (0.03):(of(scene,'exact')) with points ls 1 notitle"
}
unset title; unset border; unset tics; unset grid; unset label; unset xlabel; unset ylabel
set lmargin at screen 0.05; set rmargin at screen 0.98; set bmargin at screen 0.005; set tmargin at screen 0.07
set key center center horizontal samplen 3 width 2 Left reverse font font.",12"
unset logscale xy; set xrange [0:1]; set yrange [0:1]
plot NaN with points ls 1 title "exact, which has no step", NaN with linespoints ls 3 title "steps", \
    NaN with linespoints ls 9 title "euler", NaN with linespoints ls 4 title "article", NaN with linespoints ls 5 title "Box2D", NaN with linespoints ls 6 title "Chipmunk", \
    NaN with lines dt 3 lw 1.5 lc rgb "#999999" title "slopes 1 and 2"
unset multiplot
unset output
