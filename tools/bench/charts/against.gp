# How many times cheaper the exact method is than each peer.

against = tables."/against_peers.tsv"
eval begin("against-peers", 1300, 620)
set multiplot layout 1,3 title "How many times less processor time the exact method needs" \
    font font.",16" margins 0.09,0.985,0.04,0.82 spacing 0.02,0
set border 0; unset key; unset grid
set xrange [0.5:2.5]; set yrange [-words(scenes) - 0.5:-0.5]
unset xtics
set x2range [0.5:2.5]
set x2tics scale 0 ("Box2D" 1, "Chipmunk" 2) offset 0,-0.5
unset ytics
at_x(dummy) = place(strcol(2), "Box2D Chipmunk")
at_y(dummy) = -place(strcol(1), scenes)
wanted(c) = c == 3 ? 10 : c == 4 ? 50 : 1000
said(c) = strcol(c) eq "nan" ? "fails at every setting" : \
    (column(c) < 10 ? sprintf("%.1f times", column(c)) : sprintf("%.0f times", column(c))). \
    (strcol(c == 5 ? 8 : 7) eq "nan" ? ", and it fails" : "")
# As hoped, less, or dearer: told apart by brightness too.
shade(c) = strcol(c) eq "nan" ? 0xeeeeee : column(c) >= wanted(c) ? 0x80cbc4 : column(c) >= 1 ? 0xffe9a8 : 0xe58b6b
heading(c) = c == 3 ? "as advised, 60 Hz, asked 60 times\n10 times were hoped for" : \
    c == 4 ? "as advised, 60 Hz, asked once\n50 times were hoped for" : "at the peer's least error, asked 60 times\n1000 times were hoped for"
do for [c = 3:5] {
    set title heading(c) font font.",12" offset 0,0.3
    if (c == 3) { set ytics scale 0; do for [k = 1:words(scenes)] { set ytics add (word(scenes, k) -k) } } else { unset ytics }
    plot against using (at_x(0)):(at_y(0)):(at_x(0) - 0.48):(at_x(0) + 0.48):(at_y(0) - 0.45):(at_y(0) + 0.45):(shade(c)) \
            axes x2y1 with boxxyerror fs solid 1 noborder lc rgb variable, \
        against using (at_x(0)):(at_y(0)):(said(c)) axes x2y1 with labels textcolor rgb "#1a1a1a"
}
unset multiplot
unset output
