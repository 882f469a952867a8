# Tracks of the centre where the surface turns by beta: towards the ball they cross, away from it they miss (5.2).
eval canvas(250)
b = 34.0; r = 1.0
set xrange [-3.6:8.4]; set yrange [-1.9:2.8]
# Towards: a level floor, then one that rises by b.
c = cos(b); s = sin(b); x = -r * tan(b / 2)
set arrow from -3.4, 0 to 0, 0 as 5
set arrow from 0, 0 to 2.7 * c, 2.7 * s as 5
set arrow from -3.4, r to 0, r nohead ls 3
set arrow from -r * s - 0.55 * c, r * c - 0.55 * s to 1.9 * c - r * s, 1.9 * s + r * c nohead ls 3
set object circle at x, r size r behind fc rgb disc fs solid border lc rgb ink lw 1.5
set object circle at x, r size 0.06 front fc rgb path fs solid noborder
set arrow from x, r to x, -0.02 as 6
set arrow from x, r to x + r * s, r - r * c as 6
set arrow from -3.4, r to -2.2, r as 2
set label "v_t" at -2.9, r + 0.35 center tc rgb path
set arrow from x, -0.35 to 0, -0.35 as 7
set label "r tan(beta/2)" at x / 2 - 0.1, -0.75 center
set arrow from 0, 0 to 2.0, 0 as 6
set object circle at 0, 0 size 0.85 arc [0:b] nowedge fc rgb ink fs empty border rgb ink lw 1
set label "beta" at 1.32, 0.33 center
# Away: a level floor, then one that falls by b.
X = 5.2
set arrow from X - 2.2, 0 to X, 0 as 5
set arrow from X, 0 to X + 3.0 * c, -3.0 * s as 5
set arrow from X - 2.2, r to X, r nohead ls 3
set arrow from X + r * s, r * c to X + r * s + 2.6 * c, r * c - 2.6 * s nohead ls 3
set object circle at X, r size r behind fc rgb disc fs solid border lc rgb ink lw 1.5
set object circle at X, r size 0.06 front fc rgb path fs solid noborder
set object circle at X + r * s, r * c size 0.06 front fc rgb path fs solid noborder
set arrow from X, 0 to X, r as 6
set arrow from X, 0 to X + r * s, r * c as 6
set arrow from X, r to X + r * s, r * c as 4 front
set label "d = r beta" at X + 0.1, r + 1.25 center tc rgb force
set arrow from X, 0 to X + 2.0, 0 as 6
set object circle at X, 0 size 0.85 arc [-b:0] nowedge fc rgb ink fs empty border rgb ink lw 1
set label "beta" at X + 1.38, -0.38 center
plot NaN
