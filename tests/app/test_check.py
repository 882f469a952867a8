#!/usr/bin/env python3
"""smb2d check: every fault and every suspicion, a line each, with file and line (docs/levels.md)."""

import re

from program import ASSETS, ProgramTest, main


class Check(ProgramTest):
    def test_shipped_levels_have_no_faults_and_nothing_suspicious(self):
        levels = sorted((ASSETS / "levels").glob("*.svg")) + sorted((ASSETS / "lab").glob("*.svg"))
        self.assertGreaterEqual(len(levels), 7)
        said = self.done("check", *levels).decode()
        self.assertNotRegex(said, r"\.svg:\d+:")
        for level in levels:
            self.assertIn(f"{level}: method ", said)  # none is left out

    def test_every_fault_is_found_and_not_only_the_first(self):
        level = self.file("bad.svg", """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 4.5">
<path class="terrain" data-friction="-1" d="M 0 4 H 8"/>
<circle class="ball" cx="2" cy="3" r="0.5" data-mass="-1"/>
<circle class="ball" cx="4" cy="3" r="0"/>
</svg>
""")
        said = self.done("check", level, status=3).decode().splitlines()
        found = [re.match(r"(.*):(\d+): ", line).groups() for line in said if ".svg:" in line]
        self.assertEqual(found, [(str(level), "2"), (str(level), "3"), (str(level), "4")])

    def test_a_suspicion_is_printed_and_is_no_fault(self):
        level = self.file("odd.svg", self.small_level.read_text().replace("data-spin", "data-spim"))
        self.assertIn(f"{level}:3: ", self.done("check", level).decode())

    def test_a_wide_stroke_is_noted(self):
        drawn = self.small_level.read_text().replace('id="floor"', 'id="floor" fill="none" stroke="red"')
        level = self.file("wide.svg", drawn)
        self.assertIn(f"{level}: note: line 2: terrain: a stroke of 1 m is wider than 2 % of the ball, which touches "
                      "its middle", self.done("check", level).decode().splitlines())

    def test_a_sound_level_is_told_what_it_needs_and_which_method_is_chosen(self):
        level = self.file("bowl.svg", """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 4.5">
<path id="bowl" class="terrain" data-friction="inf" d="M 0 0 A 4 4 0 0 0 8 0"/>
<circle class="ball" cx="2" cy="1" r="0.5"/>
</svg>
""")
        lines = self.done("check", level).decode().splitlines()
        self.assertIn(f'{level}: needs arcs: surface "bowl" is round', lines)
        self.assertFalse([line for line in lines if "slip" in line or "bounces" in line])
        self.assertEqual(lines[-1].split(": ")[1], "method exact")
        self.assertGreater(len(lines[-1].split(": ")[2]), 10)

    def test_many_balls_are_left_to_steps_and_it_says_why(self):
        lines = self.done("check", ASSETS / "lab/pile.svg").decode().splitlines()
        self.assertRegex(lines[-1], r": method steps: .*piles")

    def test_with_a_tolerance_it_says_which_method_keeps_it(self):
        line = self.done("check", "--tolerance", "1e-6", self.small_level).decode().splitlines()[-1]
        self.assertRegex(line, r": method exact: .* right to rounding")
        line = self.done("check", "--tolerance", "1e-2", ASSETS / "lab" / "pile.svg").decode().splitlines()[-1]
        self.assertRegex(line, r": method steps: steps at \d+ steps/s kept 0.01 m in every pile that was measured; "
                               r"an estimate")
        line = self.done("check", "--tolerance", "1e-9", ASSETS / "lab" / "pile.svg").decode().splitlines()[-1]
        self.assertRegex(line, r": method steps: nothing is known to keep 1e-09 m; nearest, steps at \d+ steps/s")
        self.assert_fails(2, "check", "--tolerance", "0", self.small_level, says="tolerance")

    def test_a_broken_level_is_told_no_needs(self):
        level = self.file("broken.svg", self.small_level.read_text().replace('r="0.5"', 'r="-1"'))
        self.assertNotRegex(self.done("check", level, status=3).decode(), r": (needs|method) ")

    def test_one_broken_level_among_many_is_a_fault(self):
        broken = self.file("broken.svg", "<svg")
        said = self.done("check", self.small_level, broken, self.small_level, status=3)
        self.assertIn(b"broken.svg:1: ", said)


if __name__ == "__main__":
    main()
