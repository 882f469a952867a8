# Energy that should stay as it is, against time.

swings = "bounce spring valley loop"
titled(swing) = swing eq "bounce" ? "bouncing without loss, from 2 m" : swing eq "spring" ? "on a spring of 1 Hz without damping" : \
    swing eq "valley" ? "rolling to and fro in a valley" : "rolling round in a loop"
energy = tables."/energy.tsv"
least = 1e-17; most = 30
eval begin("energy", 1300, 860)
set multiplot layout 2,2 title "Energy gained or lost, as a part of what there was, 60 steps a second" font font.",16" \
    margins 0.07,0.985,0.15,0.89 spacing 0.06,0.11
set logscale y
stats energy using 3 nooutput
set xrange [0:STATS_max]; set yrange [least:most]
set ytics ("10^{-16}" 1e-16, "10^{-12}" 1e-12, "10^{-8}" 1e-8, "10^{-4}" 1e-4, "1 %%" 0.01, "all" 1)
unset key
change(swing, method) = is(swing, method) ? ($4 < 1e-17 ? 1e-17 : $4 > 10 ? 10 : $4) : NaN
do for [i = 1:4] {
    swing = word(swings, i)
    set title titled(swing) font font.",13" offset 0,-0.5
    set xlabel i > 2 ? "time, s" : "" offset 0,0.3
    plot for [m in "article euler Chipmunk Box2D steps exact"] energy using 3:(change(swing, m)) with lines ls style_of(m) lw 2.5
}
unset title; unset border; unset tics; unset grid; unset xlabel
set lmargin at screen 0.05; set rmargin at screen 0.98; set bmargin at screen 0.005; set tmargin at screen 0.07
set key center center horizontal samplen 3 width 2 Left reverse font font.",12"
unset logscale y; set xrange [0:1]; set yrange [0:1]
plot for [m in methods] NaN with lines ls style_of(m) lw 2.5 title m
unset multiplot
unset output
