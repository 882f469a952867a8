# A ball at two contacts: at rest while the load lies between the normals; spinning, between normals that friction leans (7.2).
eval canvas(290)
r = 1.0
set xrange [-2.6:7.4]; set yrange [-1.5:3.0]
do for [k = 0:1] {
    X = 4.8 * k
    a = 32.0; b = 48.0                                # how steep the two walls are
    ax = sin(a); ay = cos(a); bx = -sin(b); by = cos(b)
    vx = r * (ay - by) / (ax * by - ay * bx); vy = -r * (ax - bx) / (ax * by - ay * bx)   # where the walls meet
    lean = k * 14.0                                   # the angle of friction
    R = 2.0
    set object circle at X, 0 size R arc [90 - a + lean:90 + b + lean] behind fc rgb shade fs solid border lc rgb shade
    set arrow from X + vx, vy to X + vx - 2.9 * cos(a), vy + 2.9 * sin(a) as 5
    set arrow from X + vx, vy to X + vx + 2.7 * cos(b), vy + 2.7 * sin(b) as 5
    set object circle at X, 0 size r behind fc rgb disc fs solid 1 border lc rgb ink lw 1.5
    set object circle at X, 0 size 0.05 front fc rgb ink fs solid noborder
    set arrow from X - r * ax, -r * ay to X + R * ax, R * ay as (k == 0 ? 1 : 6) front
    set arrow from X - r * bx, -r * by to X + R * bx, R * by as (k == 0 ? 1 : 6) front
    if (k == 1) {
        px = sin(a - lean); py = cos(a - lean); qx = -sin(b + lean); qy = cos(b + lean)
        set arrow from X, 0 to X + R * px, R * py as 1 front
        set arrow from X, 0 to X + R * qx, R * qy as 1 front
        set label "P_a" at X + 2.2 * px, 2.2 * py center
        set label "P_b" at X + 2.2 * qx, 2.2 * qy center
    } else {
        set label "n_a" at X + 2.2 * ax, 2.2 * ay center
        set label "n_b" at X + 2.2 * bx, 2.2 * by center
    }
    set arrow from X, 0 to X, 1.55 as 4 front
    set label "-A" at X + 0.12, 1.25 left tc rgb force front
}
set label "at rest" at 0, 2.75 center
set label "spinning" at 4.8, 2.75 center
set parametric
set trange [150:215]
plot 4.8 + 0.7 * cos(t), 0.7 * sin(t) ls 5, \
     '+' using (4.8 + 0.7 * cos(213)):(0.7 * sin(213)):(0.04):(-0.07) every ::0::0 with vectors as 1
