#!/usr/bin/env python3
"""Run files: what verify accepts and finds, and which runs are refused (docs/runs-and-traces.md)."""

import csv
import io
import json
import struct

from program import ASSETS, ProgramTest, main


def fnv1a(data):
    """64-bit FNV-1a in hex, from its definition."""
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


class Runs(ProgramTest):
    def write(self, name="run.json", **changes):
        run = {"smb2d": 1, "level": "small.svg", "method": "euler", "rate": 240, "duration": 2, "inputs": [
            {"t": 0.5, "grab": {"ball": 0, "x": 2.5, "y": 1.0}}, {"t": 0.75, "move": {"x": 3.0, "y": 2.0}},
            {"t": 1.0, "release": True}, {"t": 1.25, "tilt": 0.1}]}
        run.update(changes)
        return self.file(name, json.dumps({key: value for key, value in run.items() if value is not None}))

    def claims(self, time=2):
        """What a run that was played ends with, from the trace: 17 digits give back every bit."""
        trace = self.done("simulate", self.write(), "--to", time, "--every", time).decode()
        last = [row for row in csv.DictReader(io.StringIO(trace)) if float(row["t"]) == time]
        state = b"".join(struct.pack("<6d", *(float(row[name]) for name in ["x", "y", "vx", "vy", "angle", "spin"]))
                         for row in last)
        return {"level_hash": fnv1a(self.small_level.read_bytes()),
                "final": {"time": time, "state_hash": fnv1a(state)}}

    def test_a_true_run_is_verified(self):
        self.done("verify", self.write(**self.claims()))

    def test_an_end_without_a_hash_claims_its_time(self):
        for time, status in [(2, 0), (1.5, 3)]:
            self.done("verify", self.write(duration=2, final={"time": time}), status=status)

    def test_a_tampered_run_is_found_out(self):
        claims = self.claims()
        grabbed_elsewhere = [{"t": 0.5, "grab": {"ball": 0, "x": 2.6, "y": 1.0}}, {"t": 1.0, "release": True}]
        for lie in [{"final": {"time": 2, "state_hash": "0123456789abcdef"}}, {"level_hash": "0123456789abcdef"},
                    {"final": {**claims["final"], "time": 1.5}}, {"inputs": grabbed_elsewhere}, {"rate": 120}]:
            result = self.smb2d("verify", self.write(**{**claims, **lie}))
            self.assertEqual(result.returncode, 3, (lie, result.stdout, result.stderr))

    def test_one_liar_among_many_runs_is_found_out(self):
        claims = self.claims()
        true = self.write("true.json", **claims)
        liar = self.write("liar.json", **{**claims, "level_hash": "0123456789abcdef"})
        result = self.smb2d("verify", true, liar, true)
        self.assertEqual(result.returncode, 3)
        self.assertIn(b"liar.json", result.stdout + result.stderr)

    def test_a_changed_level_is_said_and_simulated(self):
        run = self.write(level_hash="0123456789abcdef")
        result = self.smb2d("simulate", run)
        self.assertEqual(result.returncode, 0)
        self.assert_one_line(result.stderr)

    def test_the_level_is_found_beside_the_run(self):
        (self.folder / "deep").mkdir()
        run = self.write("deep/run.json", level="../small.svg")
        self.done("simulate", run)

    def test_shipped_runs_reach_their_goals(self):
        runs = sorted((ASSETS / "runs").glob("*.json"))
        self.assertGreaterEqual(len(runs), 2)
        for run in runs:
            rows = [line.split(",") for line in self.done("simulate", run, "--events").decode().splitlines()]
            kinds = [row[2] for row in rows]
            falls = [row for row in rows if row[2] == "fall" and row[1] == "0"]  # other balls may fall
            self.assertEqual((kinds.count("goal"), len(falls)), (1, 0), run.name)
            # A dozen joints are passed on the way: a ball that swings over one for ever tells thousands.
            self.assertLess(kinds.count("joint"), 100, run.name)

    def test_what_is_wrong_is_named(self):
        grab = {"t": 1, "grab": {"ball": 0, "x": 1, "y": 1}}
        for says, changes in [("smb2d", {"smb2d": None}), ("smb2d", {"smb2d": 2}), ("colour", {"colour": "red"}),
                              ("level", {"level": None}), ("nowhere.svg", {"level": "nowhere.svg"}),
                              ("method", {"method": "guess"}), ("rate", {"rate": -1}), ("duration", {"duration": "x"}),
                              ("inputs[0]", {"inputs": [{"t": 1, "move": {"x": 1, "y": 1}}]}),
                              ("inputs[1]", {"inputs": [grab, {"t": 0.5, "release": True}]}),
                              ("inputs[0]", {"inputs": [{**grab, "tilt": 0.1}]}),
                              ("inputs[0]", {"inputs": [{"t": 1}]}),
                              ("z", {"inputs": [{"t": 1, "grab": {"ball": 0, "x": 1, "y": 1, "z": 1}}]}),
                              ("inputs[0]", {"inputs": [{"t": 1, "grab": {"ball": 9, "x": 1, "y": 1}}]}),
                              ("inputs[0]", {"inputs": [{"t": -1, "tilt": 0.1}]})]:
            run = self.write(**{"final": {"time": 2, "state_hash": "0123456789abcdef"}, **changes})
            self.assert_fails(1, "simulate", run, says=says)
            self.assert_fails(1, "verify", run, says=says)

    def test_what_is_not_a_run_is_refused(self):
        for text in ["", "{", "[]", "3", '{"smb2d": 1, "smb2d": 1, "level": "small.svg"}', "\0\1\2",
                     '{"smb2d": 1, "level": "small.svg", "inputs": [{"t": 1e999, "tilt": 0}]}']:
            self.file("bad.json", text)
            self.assert_fails(1, "simulate", "bad.json", says="bad.json")


if __name__ == "__main__":
    main()
