# Hops that shrink by e, and the time at which they end (6.1).
eval canvas(260)
set size noratio
e = 0.72; g = 1.0; v0 = 1.0
T = 2 * v0 / (g * (1 - e))
set xrange [-0.35:T + 0.9]; set yrange [-0.17:0.62]
start(i) = 2 * v0 / g * (1 - e**i) / (1 - e)
# Which hop a time lies in, and the height there.
hop(t) = floor(log(1 - t * g * (1 - e) / (2 * v0)) / log(e))
height(t) = t >= T - 1e-4 ? 0 : (i = hop(t), s = t - start(i), v0 * e**i * s - g * s * s / 2)
set arrow from -0.3, 0 to T + 0.8, 0 as 5
do for [i = 0:2] {
    set arrow from start(i), -0.05 to start(i + 1), -0.05 as 7
    set label (i == 0 ? "2 v0 / N" : i == 1 ? "e" : "e^2") at 0.5 * (start(i) + start(i + 1)), -0.1 center
}
set arrow from 0, 0 to 0.42, 0.42 as 4 front
set label "v0" at 0.22, 0.38 right tc rgb force
set label "height over time" at T + 0.75, 0.56 right
set arrow from T, 0 to T, 0.2 as 6
set label "T = 2 v0 / (N (1 - e))" at T + 0.75, 0.26 right
set samples 700
plot sample [0:T] height(x) with lines ls 2, \
     [0:1] '+' using (T):(0) every ::0::0 with points pt 7 ps 0.7 lc rgb path
