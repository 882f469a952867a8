# What each need of a scene adds to its cost.

needs = tables."/needs.tsv"
eval begin("needs", 1100, 560)
set title "What a scene pays for: processor time for a simulated second, asked 60 times" font font.",16" offset 0,0.5
set border 1
set style data histograms
set style histogram clustered gap 1
set style fill solid 1 noborder
set boxwidth 0.92
set grid noxtics
set xtics scale 0 nomirror
set logscale y
set yrange [0.1:500]
set ytics ("0.1 µs" 0.1, "1 µs" 1, "10 µs" 10, "100 µs" 100)
set key top left samplen 2 spacing 1.3 Left reverse
said(c) = column(c) < 1e4 ? sprintf("%.1f", column(c) / 1e3) : sprintf("%.0f", column(c) / 1e3)
plot needs using ($2 / 1e3):xtic(1) ls 1 title "exact", needs using ($3 / 1e3) ls 3 title "steps, 240 Hz", \
    needs using ($0 - 0.17):($2 / 1e3):(said(2)) with labels center offset 0,0.7 tc rgb "#333333" notitle, \
    needs using ($0 + 0.17):($3 / 1e3):(said(3)) with labels center offset 0,0.7 tc rgb "#333333" notitle
unset output
