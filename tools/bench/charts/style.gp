# What all charts share. gnuplot -e "tables='FOLDER'; charts='FOLDER'; kind='svg'" style.gp NAME.gp (or kind='png')

set encoding utf8
set datafile separator "\t"
set macros
font = "DejaVu Sans"
# A picture of this size in pixels, NAME.svg or NAME.png.
begin(name, width, height) = kind eq "svg" ? \
    sprintf("set terminal svg size %d,%d dynamic background '#ffffff' font '%s,13'; set output '%s/%s.svg'", \
            width, height, font, charts, name) : \
    sprintf("set terminal pngcairo size %d,%d background '#ffffff' font '%s,10'; set output '%s/%s.png'", \
            width, height, font, charts, name)

# A colour and a mark to each method, the same in every chart.
set style line 1 lc rgb "#00796b" lw 2.5 pt 13 ps 1.5   # exact
set style line 2 lc rgb "#80cbc4" lw 1.5 pt 12 ps 1.0   # exact on pieces
set style line 3 lc rgb "#1e66c8" lw 2.5 pt 7  ps 0.9   # steps
set style line 4 lc rgb "#9e9e9e" lw 1.5 pt 7  ps 0.7   # article
set style line 5 lc rgb "#e08214" lw 2.0 pt 5  ps 0.9   # Box2D
set style line 6 lc rgb "#c2185b" lw 2.0 pt 9  ps 1.0   # Chipmunk
set style line 7 lc rgb "#e08214" lw 1.5 dt 2 pt 4 ps 0.9   # Box2D on finer pieces
set style line 8 lc rgb "#c2185b" lw 1.5 dt 2 pt 8 ps 1.0   # Chipmunk on finer pieces
set style line 9 lc rgb "#6a4c93" lw 2.0 pt 11 ps 1.0  # euler
colour(i) = word("#00796b #80cbc4 #1e66c8 #9e9e9e #e08214 #c2185b #e08214 #c2185b #6a4c93", i)
methods = "exact steps euler article Box2D Chipmunk"
place(name, list) = sum [k = 1:words(list)] (word(list, k) eq name ? k : 0)
style_of(method) = int(word("1 3 9 4 5 6", place(method, methods)))

# Which block of a table, from 0, is a method's: block[i] of the i-th after eval find_blocks(table). Forgets ranges.
array block[words(methods)]
find_blocks(table) = sprintf("set autoscale; do for [k = 1:words(methods)] { \
    stats '%s' using (strcol(1) eq word(methods, k) ? column(-2) : NaN) nooutput; block[k] = int(STATS_min) }", table)

set border 3 lc rgb "#555555"
set tics nomirror textcolor rgb "#333333"
set style line 20 lc rgb "#e6e6e6" lw 1
set grid back ls 20

scenes = "ramp skid slide bounce valley hill loop drag-soft drag-stiff flat wall pair row"
title_of(scene) = scene eq "ramp" ? "rolling down a ramp, 10 s" : \
    scene eq "skid" ? "a skid that ends in rolling, 10 s" : scene eq "slide" ? "sliding, too steep to grip, 10 s" : \
    scene eq "bounce" ? "bouncing to rest, 8 s" : scene eq "valley" ? "to and fro in a round valley, 20 s" : \
    scene eq "hill" ? "off a hill into the air, 1.75 s" : scene eq "loop" ? "inside a loop, 5 s" : \
    scene eq "drag-soft" ? "dragged by a soft spring, 4 s" : scene eq "drag-stiff" ? "dragged by a stiff spring, 4 s" : \
    scene eq "flat" ? "over 200 flat pieces, 8 s" : scene eq "wall" ? "10 km/s against a thin wall, 0.1 s" : \
    scene eq "pair" ? "one ball hits another, 4 s" : "a ball hits a row of five, 4 s"

results = tables."/results.tsv"
is(scene, method) = strcol(1) eq scene && strcol(2) eq method

# Nanoseconds, for people.
in_words(ns) = ns < 1e3 ? sprintf("%.0f ns", ns) : ns < 1e4 ? sprintf("%.1f µs", ns / 1e3) : \
    ns < 1e6 ? sprintf("%.0f µs", ns / 1e3) : sprintf("%.1f ms", ns / 1e6)
