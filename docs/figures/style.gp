# What all figures share: a drawing to scale without axes. `name` is given by tools/figures.
ink = "#222222"; ground = "#8a6d3b"; disc = "#d9e8f5"; path = "#2a6fb0"; force = "#c0392b"; shade = "#f6dfa9"
wide = 640
canvas(high) = sprintf("set term svg size %d,%d font 'sans-serif,15' background 'white'; set output name . '.svg'", wide, high)
unset key; unset border; unset tics; set size ratio -1
set margins 0, 0, 0, 0
set style line 1 lc rgb ground lw 3
set style line 2 lc rgb path lw 2
set style line 3 lc rgb path lw 1.5 dt (8, 6)
set style line 4 lc rgb force lw 2
set style line 5 lc rgb ink lw 1.5
set style line 6 lc rgb ink lw 1 dt (3, 4)
set style arrow 1 head filled size screen 0.018, 20 ls 5
set style arrow 2 head filled size screen 0.018, 20 ls 2
set style arrow 4 head filled size screen 0.018, 20 ls 4
set style arrow 5 nohead ls 1
set style arrow 6 nohead ls 6
set style arrow 7 heads filled size screen 0.012, 20 ls 5
set angles degrees
