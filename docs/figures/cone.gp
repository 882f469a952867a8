# The directions in which a vertex can be touched, and a ball that pivots about it (5.3).
eval canvas(330)
r = 1.0; b = 62.0; p = 0.42 * b                      # the surface turns away by b; the ball has turned by p
set xrange [-3.6:4.2]; set yrange [-1.6:2.65]
R = 2.4
set object circle at 0, 0 size R arc [90 - b:90] behind fc rgb shade fs solid border lc rgb shade
set arrow from -3.4, 0 to 0, 0 as 5
set arrow from 0, 0 to 1.9 * cos(b), -1.9 * sin(b) as 5
set object circle at r * sin(p), r * cos(p) size r behind fc rgb disc fs transparent solid 0.8 noborder
set object circle at r * sin(p), r * cos(p) size r fs empty border lc rgb ink lw 1.5
set object circle at r * sin(p), r * cos(p) size 0.05 front fc rgb path fs solid noborder
set arrow from 0, 0 to 0, R as 6
set arrow from 0, 0 to R * sin(b), R * cos(b) as 6
set arrow from r * sin(p), r * cos(p) to r * sin(p) + 1.5 * cos(p), r * cos(p) - 1.5 * sin(p) as 2 front
set label "v_t" at r * sin(p) + 1.65 * cos(p), r * cos(p) - 1.65 * sin(p) left tc rgb path
set arrow from 0, 0 to 0.62 * sin(p), 0.62 * cos(p) as 4 front
set label "N" at 0.4 * sin(p) + 0.3, 0.4 * cos(p) - 0.02 center tc rgb force front
set label "a quarter turn" at -0.15, 2.3 right
set label "from either edge" at -0.15, 2.03 right
set label "cone: beta wide" at R * sin(b) + 0.12, R * cos(b) + 0.05 left
set object circle at 0, 0 size 0.6 arc [-b:180] nowedge fc rgb ink fs empty border rgb ink lw 1
set label "gamma = pi + beta" at -0.75, 0.3 right
set arrow from 0, 0 to 1.5, 0 as 6
set object circle at 0, 0 size 0.85 arc [-b:0] nowedge fc rgb ink fs empty border rgb ink lw 1
set label "beta" at 1.12, -0.55 center
set parametric
set trange [0:1]
plot r * cos(90 - b * t), r * sin(90 - b * t) ls 3
