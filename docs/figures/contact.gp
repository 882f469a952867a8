# A disc on a slope: normal, tangent, speeds and spin (1.1).
eval canvas(320)
a = -20.0; r = 1.0
tx = cos(a); ty = sin(a); nx = -sin(a); ny = cos(a)   # t down the slope, n off it
cx = r * nx; cy = r * ny                              # the contact is the origin
set xrange [-4.0:4.4]; set yrange [-1.7:2.5]
set arrow from -3.7 * tx, -3.7 * ty to 4.2 * tx, 4.2 * ty as 5
set object circle at cx, cy size r fc rgb disc fs solid border lc rgb ink lw 1.5
set object circle at 0, 0 size 0.05 front fc rgb ink fs solid noborder
set object circle at cx, cy size 0.05 front fc rgb ink fs solid noborder
set arrow from 0, 0 to cx, cy as 6 front
set label "r" at 0.5 * cx - 0.22, 0.5 * cy - 0.05 front
# The frame, beside the disc.
fx = -2.7 * tx; fy = -2.7 * ty
set arrow from fx, fy to fx + nx, fy + ny as 1
set arrow from fx, fy to fx + tx, fy + ty as 1
set label "n" at fx + 1.12 * nx, fy + 1.12 * ny center
set label "t" at fx + 0.75 * tx + 0.2 * nx, fy + 0.75 * ty + 0.2 * ny center
set arrow from cx, cy to cx + 1.9 * tx, cy + 1.9 * ty as 2 front
set label "v_t" at cx + 2.1 * tx, cy + 2.1 * ty left tc rgb path front
set arrow from cx, cy to cx + 0.8 * nx, cy + 0.8 * ny as 2 front
set label "v_n" at cx + 0.8 * nx - 0.35, cy + 0.8 * ny + 0.12 center tc rgb path front
# What touches slips by u.
set arrow from 0, 0 to 0.9 * tx, 0.9 * ty as 4 front
set label "u = v_t - s" at 1.0 * tx + 0.22 * nx, 1.0 * ty + 0.22 * ny left tc rgb force front
# The rim in the rolling sense, clockwise.
set label "s = -r w" at cx - 1.1, cy + 0.95 right
set parametric
set trange [115:200]
R = 1.22
plot cx + R * cos(t), cy + R * sin(t) ls 5, \
     '+' using (cx + R * cos(118)):(cy + R * sin(118)):(0.2 * cos(27)):(0.2 * sin(27)) every ::0::0 with vectors as 1
