#!/usr/bin/env python3
"""Traces: grid, names, formats and a few numbers that are known (docs/command-line.md, docs/runs-and-traces.md)."""

import csv
import io
import json
import math

from program import ASSETS, ProgramTest, main, until

COLUMNS = "t,ball,x,y,angle,vx,vy,spin,phase,surface"
EVENT_COLUMNS = "t,ball,event,x,y,vx,vy,spin,surface,other"


class Simulate(ProgramTest):
    def rows(self, *words):
        text = self.done("simulate", *words).decode()
        return list(csv.DictReader(io.StringIO(text)))

    def test_the_header_stands_first(self):
        self.assertEqual(self.done("simulate", self.small_level).decode().splitlines()[0], COLUMNS)
        self.assertEqual(self.done("simulate", self.small_level, "--events").decode().splitlines()[0], EVENT_COLUMNS)

    def test_rows_stand_at_whole_multiples_up_to_and_including_the_end(self):
        for every, step, to, count in [("1/24", 1 / 24, "1", 25), ("0.1", 0.1, "0.3", 4), ("0.1", 0.1, "0.35", 4),
                                       ("1/60", 1 / 60, "0.5", 31), ("0.25", 0.25, "0", 1)]:
            times = [float(row["t"]) for row in self.rows(self.small_level, "--every", every, "--to", to)]
            self.assertEqual(len(times), count, (every, to))
            for i, time in enumerate(times):
                self.assertAlmostEqual(time, i * step, delta=1e-15)  # a bit or two of i * step

    def test_ten_seconds_sixty_times_a_second_unless_told_otherwise(self):
        times = [float(row["t"]) for row in self.rows(self.small_level)]
        self.assertEqual((len(times), times[-1]), (601, 10.0))

    def test_a_runs_duration_ends_it(self):
        run = self.file("run.json", '{"smb2d": 1, "level": "small.svg", "duration": 0.5}')
        self.assertEqual(len(self.rows(run)), 31)

    def test_balls_come_in_the_order_of_the_file(self):
        rows = self.rows(ASSETS / "lab/row.svg", "--to", "0.1", "--every", "0.1")
        self.assertEqual([int(row["ball"]) for row in rows], [0, 1, 2, 3, 4, 5] * 2)
        self.assertEqual([float(row["x"]) for row in rows[:6]], [1.5, 5.5, 6.5, 7.5, 8.5, 9.5])

    def test_numbers_survive_the_way_through_text(self):
        for row in self.rows(ASSETS / "lab/ramp.svg", "--to", "1"):
            for name in ["x", "y", "vx", "vy", "angle", "spin"]:
                self.assertEqual(float("%.17g" % float(row[name])), float(row[name]))
                self.assertLessEqual(len(row[name].lstrip("-").replace(".", "").split("e")[0].lstrip("0")), 17)

    def test_a_rolling_ball_rolls_on_its_surface(self):
        rows = self.rows(self.small_level, "--to", "1", "--every", "1")
        self.assertEqual((rows[1]["phase"], rows[1]["surface"]), ("roll", "floor"))
        self.assertAlmostEqual(float(rows[1]["x"]), 3, delta=1e-3)      # 1 m/s for 1 s
        self.assertAlmostEqual(float(rows[1]["angle"]), -2, delta=1e-2)  # x / r, clockwise

    def test_the_ramp_is_rolled_down_as_its_description_says_and_half_as_far_again_without_spin_energy(self):
        for method, share in [("steps", 3), ("article", 2)]:  # physics.md 3.3
            start, end = self.rows(ASSETS / "lab/ramp.svg", "--method", method, "--to", "4", "--every", "4")
            rolled = math.hypot(float(end["x"]) - float(start["x"]), float(end["y"]) - float(start["y"]))
            expected = 9.81 * math.sin(math.radians(15)) * 16 / share
            self.assertAlmostEqual(rolled, expected, delta=0.01 * expected, msg=method)

    def test_json_says_the_same_as_csv(self):
        for words in [[], ["--events"]]:
            words = [ASSETS / "lab/bounce.svg", "--to", "2", *words]
            table = self.rows(*words)
            objects = [json.loads(line) for line in self.done("simulate", "--format", "json", *words).splitlines()]
            self.assertEqual(len(table), len(objects))
            for row, thing in zip(table, objects):
                self.assertEqual(list(row), list(thing))
                for name, value in thing.items():
                    if isinstance(value, (int, float)):
                        self.assertEqual(float(row[name]), value)
                    else:
                        self.assertEqual(row[name], value or "")

    def test_a_dropped_ball_bounces_on_the_floor(self):
        events = self.rows(ASSETS / "lab/bounce.svg", "--method", "steps", "--events", "--to", "3")
        first = next(event for event in events if event["event"] == "bounce")
        self.assertEqual((first["surface"], first["ball"]), ("floor", "0"))
        self.assertAlmostEqual(float(first["t"]), math.sqrt(4 / 9.81), delta=2 / 240)  # to a step or two

    def test_what_the_player_does_is_among_the_events(self):
        kinds = [event["event"] for event in self.rows(ASSETS / "runs/demo.json", "--events")]
        self.assertEqual(kinds.count("grab"), 2)
        self.assertEqual(kinds.count("release"), 2)
        self.assertIn("banana", kinds)
        self.assertEqual(kinds.count("goal"), 1)

    def test_the_same_call_gives_the_same_bytes(self):
        words = ["simulate", ASSETS / "runs/demo.json"]
        self.assertEqual(self.done(*words), self.done(*words))

    def test_an_interrupt_ends_it_with_130(self):
        with open(self.folder / "trace.csv", "wb") as trace:
            process = self.start("simulate", self.small_level, "--to", "1e7", stdout=trace)
            until(lambda: (self.folder / "trace.csv").stat().st_size > 1000, "the first rows", process)
            self.assert_interrupted(process)


if __name__ == "__main__":
    main()
