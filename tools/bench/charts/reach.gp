# The cheapest way to an accuracy, scene by method.

x_of(dummy) = place(strcol(2), methods)
y_of(dummy) = -place(strcol(1), scenes)
said(c) = strcol(c) eq "never" ? "never" : in_words(column(c))
accuracy(c) = (c == 3) ? "to one pixel, 12.5 mm" : (c == 4) ? "to a micrometre" : "to a tenth of a nanometre"
eval begin("reach", 1300, 620)
reach = tables."/reach.tsv"
set multiplot layout 1,3 title "What it costs to be this accurate: processor time for a simulated second, asked 60 times" \
    font font.",16" margins 0.08,0.985,0.04,0.84 spacing 0.015,0
set border 0; unset key; unset colorbox; unset grid
set xrange [0.5:words(methods) + 0.5]; set yrange [-words(scenes) - 0.5:-0.5]
set palette defined (0 "#1b9e77", 1.2 "#a6dba0", 2.2 "#fff3b0", 3.2 "#f7a35c", 4.3 "#d6604d")
set cbrange [3:7.3]
unset ytics
unset xtics
set x2range [0.5:words(methods) + 0.5]
set x2tics scale 0 () offset 0,-0.5
do for [k = 1:words(methods)] { set x2tics add (word(methods, k) k) }
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
