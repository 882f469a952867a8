# Maps of what holds at 60 steps a second: the drag spring, walls, columns.

# The drag spring.
eval begin("drag-stability", 1300, 760)
unset x2tics; unset xtics; unset ytics; unset title
set multiplot layout 2,3 title "The drag spring at 60 steps a second: how far the answer to a sudden pull is off, and where the ball runs away" \
    font font.",16" margins 0.06,0.88,0.09,0.88 spacing 0.03,0.1
drag = tables."/drag.tsv"
eval find_blocks(drag)
set border 15 lc rgb "#555555"
set xrange [log10(0.5):log10(60)]; set yrange [0:2]
set xtics scale 0.5 nomirror ("0.5" log10(0.5), "1" 0, "2" log10(2), "5" log10(5), "10" 1, "20" log10(20), "50" log10(50))
set ytics scale 0.5 nomirror 0.5
set palette defined (-15 "#1a5276", -11 "#2e86c1", -6 "#a9dfbf", -2 "#f9e79f", -1 "#f5b041", 0 "#dc7633", 0.45 "#cb4335", 0.46 "#2b2b2b", 1 "#2b2b2b")
set cbrange [-15:1]
set format "%g"
bound(z) = log10(60 / pi * (sqrt(1 + z * z) - z))
set samples 200
do for [i = 0:5] {
    unset colorbox
    if (i == 2) { set colorbox user origin 0.905,0.09 size 0.018,0.79; \
        set cbtics scale 0 ("10^{-15}" -15, "10^{-12}" -12, "10^{-9}" -9, "10^{-6}" -6, "10^{-3}" -3, "all" 0, "runs away" 0.75) }
    name = word(methods, i + 1)
    set title name eq "euler" ? "euler, the plain loop" : name font font.",13" offset 0,-0.5
    set xlabel i > 2 ? "frequency of the spring, Hz" : "" offset 0,0.3
    set ylabel i % 3 == 0 ? "damping, of critical" : ""
    plot drag index block[i + 1] using (log10($2)):3:($5 == 1 ? log10($4 < 1e-15 ? 1e-15 : $4 > 2.5 ? 2.5 : $4) : 1) with image notitle, \
        "+" using (bound(2 * ($1 - log10(0.5)) / (log10(60) - log10(0.5)))):(2 * ($1 - log10(0.5)) / (log10(60) - log10(0.5))) \
            with lines lw 2 dt 2 lc rgb "#ffffff" notitle
}
unset multiplot
unset output

# Walls.
eval begin("walls", 1300, 420)
set multiplot layout 1,6 title "A ball of radius 0.5 m thrown at a wall, 60 steps a second: how many get through" \
    font font.",16" margins 0.06,0.98,0.16,0.78 spacing 0.02,0
unset colorbox
set palette defined (0 "#d4e6f1", 0.001 "#f5b041", 0.5 "#cb4335", 1 "#2b2b2b")
walls = tables."/walls.tsv"
eval find_blocks(walls)
set cbrange [0:1]
set xrange [0:5]; set yrange [0:2]
set xtics scale 0.5 nomirror ("1" 0, "10" 1, "100" 2, "1000" 3, "10^4" 4)
step_past = log10(60 * 0.5)  # a radius a step, m/s
do for [i = 0:5] {
    set title word(methods, i + 1) font font.",13" offset 0,-0.5
    set xlabel "speed, m/s" offset 0,0.3
    set ylabel i == 0 ? "thickness of the wall, m" : ""
    if (i > 0) { set ytics scale 0.5 ("" 0, "" 0.5, "" 1, "" 1.5, "" 2) } else { set ytics scale 0.5 nomirror autofreq 0.5 }
    plot walls index block[i + 1] using (log10($2)):3:4 with image notitle, \
        "+" using (step_past):($1 * 2 / 5) with lines lw 2 dt 2 lc rgb "#7f8c8d" notitle
}
unset multiplot
unset output

# Columns of discs with a heavy one on top.
eval begin("stacks", 1300, 860)
unset colorbox; unset grid
set multiplot layout 2,3 columnsfirst title "A heavy ball on a column of balls of 1 kg, 60 frames a second: deepest overlap, in hundredths of a diameter" \
    font font.",16" margins 0.06,0.98,0.08,0.88 spacing 0.03,0.12
stacks = tables."/stacks.tsv"
heights = "1 2 3 5 7 10 15 20 30 40 50"
ratios = "1 2 5 10 20 50 100 200 400"
set border 0
set xrange [-0.5:10.5]; set yrange [-0.5:8.5]
set xtics scale 0 nomirror (); set ytics scale 0 nomirror ()
do for [k = 1:words(heights)] { set xtics add (word(heights, k) k - 1) }
set palette defined (-3 "#e8f1f8", -2 "#a9cfe4", -1.3 "#f9e79f", -1 "#f5b041", -0.5 "#cb4335", 0 "#7b241c")
set cbrange [-3:0]
percent(c) = column(c) < 0.01 ? sprintf("%.1f", 100 * column(c)) : sprintf("%.0f", 100 * column(c))
column_of(height) = place(sprintf("%d", int(height)), heights) - 1
row_of(ratio) = place(sprintf("%d", int(ratio)), ratios) - 1
fell(c) = column(c) > 1
# Weight above of so many balls: a unit pair at f Hz gives way by 2 g / (2 pi f)^2 for each (steps alone, whose f is 60
# at 60 steps a second and 120 at 240).
carried(overlap, f) = overlap * (2 * pi * f)**2 / (2 * 9.81)
row_at(weight) = weight >= 1 && weight <= 400 ? 3 * log10(weight) : NaN
law(overlap, height, i) = row_at(carried(overlap, i == 0 ? 60 : 120) - height + 1)
set samples 11
do for [i = 0:5] {
    set xlabel i % 2 == 1 ? "balls in the column" : "" offset 0,0.3
    set ylabel i < 2 ? "mass of the ball on top, kg" : "" offset -1,0
    if (i < 2) { do for [k = 1:words(ratios)] { set ytics add (word(ratios, k) k - 1) } } else { set format y ""; set ytics scale 0 () }
    set title word("steps steps Box2D Box2D Chipmunk Chipmunk", i + 1).", ".word("60 240 8 32 10 40", i + 1).(i < 2 ? " Hz" : " iterations") \
        font font.",13" offset 0,-0.5
    plot stacks index i using (column_of($3)):(row_of($4)):(column_of($3) - 0.47):(column_of($3) + 0.47):(row_of($4) - 0.45):(row_of($4) + 0.45): \
            (fell(5) ? NaN : log10($5 < 1e-3 ? 1e-3 : $5)) with boxxyerror fs solid 1 noborder lc palette notitle, \
        stacks index i using (fell(5) ? column_of($3) : NaN):(row_of($4)):(column_of($3) - 0.47):(column_of($3) + 0.47):(row_of($4) - 0.45):(row_of($4) + 0.45) \
            with boxxyerror fs solid 1 noborder lc rgb "#2b2b2b" notitle, \
        stacks index i using (fell(5) || $5 > 0.25 ? NaN : column_of($3)):(row_of($4)):(percent(5)) with labels font font.",8" tc rgb "#1a1a1a" notitle, \
        stacks index i using ($5 > 0.25 ? column_of($3) : NaN):(row_of($4)):(fell(5) ? "fell" : percent(5)) with labels font font.",8" tc rgb "#ffffff" notitle, \
        [0:10] "+" using (i < 2 ? $1 : NaN):(law(0.001, real(word(heights, int($1 + 1.5))), i)) with lines lw 2 dt 2 lc rgb "#1e66c8" notitle, \
        [0:10] "+" using (i < 2 ? $1 : NaN):(law(0.01, real(word(heights, int($1 + 1.5))), i)) with lines lw 2 dt 2 lc rgb "#1e66c8" notitle
}
unset multiplot
unset output
