#!/usr/bin/env python3
"""A tolerance is kept where it can be promised; else it is said to be an estimate, measured, and a miss is a failure."""

from program import ProgramTest, main

FLOOR = '<path class="terrain" d="M0 8H16M0 8V0M16 8V0"/>'


def ball(x, y, **attributes):
    return f'<circle class="ball" cx="{x}" cy="{y}" r="0.5" ' + " ".join(
        f'data-{name}="{value}"' for name, value in attributes.items()) + "/>"


class ToleranceTest(ProgramTest):
    def level(self, name, *shapes):
        return self.file(name, '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 9">' + "".join(shapes) + "</svg>")

    def asked(self, subcommand, level, tolerance, *words):
        """The exit status, and what is said before the run and at its end."""
        result = self.smb2d(subcommand, level, "--tolerance", tolerance, *words)
        lines = result.stderr.decode().splitlines()
        self.assertLessEqual(len(lines), 2)
        return result.returncode, lines

    def assert_missed(self, level, tolerance, *words):
        status, lines = self.asked("simulate", level, tolerance, *words)
        self.assertEqual((status, len(lines)), (1, 2), lines)
        self.assertIn("an estimate", lines[0])
        self.assertIn("was missed", lines[1])
        return lines[1]

    def test_a_pile_that_overlaps_by_more_than_the_tolerance_is_a_failure_that_says_what_was_reached(self):
        # Soft contacts sag by the weight borne over m_eff (2 pi f)^2, f = 30 Hz: at 9.81 m/s^2 0.55 mm for one unit mass
        # on another, of which the ground's share is smaller still; a hundred on one is deeper by far more than 0.1 mm.
        heavy = self.level("heavy.svg", FLOOR, ball(8, 7.5, mass=1), ball(8, 6.5, mass=100))
        self.assertRegex(self.assert_missed(heavy, "1e-4", "--to", "3"), r"m of overlap at .* s, stepped since .* s$")
        stacked = self.level("stacked.svg", FLOOR, ball(8, 7.5, mass=1), ball(8, 6.5, mass=1))
        self.assert_missed(stacked, "1e-6", "--to", "3")
        status, lines = self.asked("simulate", stacked, "1e-2", "--to", "3")
        self.assertEqual((status, len(lines)), (0, 1), lines)
        self.assertIn("an estimate", lines[0])

    def test_a_method_that_strays_from_the_exact_path_is_a_failure(self):
        step = self.level("step.svg", '<path class="terrain" data-friction="inf" d="M0 8H8V7.9H16"/>',
                          '<circle class="ball" cx="4" cy="7.5" r="0.5" data-velocity="1.3198 0" data-spin="-2.6396"/>')
        self.assertRegex(self.assert_missed(step, "1e-5", "--method", "euler", "--to", "8"),
                         r"m from the exact path at .* s$")

    def test_one_ball_under_a_method_that_keeps_to_its_legs_needs_no_word(self):
        for method in ["steps", "exact"]:
            status, lines = self.asked("simulate", self.small_level, "1e-9", "--method", method, "--to", "3")
            self.assertEqual((status, len(lines)), (0, 0), lines)

    def test_what_is_promised_is_kept_and_no_estimate(self):
        status, lines = self.asked("simulate", self.small_level, "1e-9", "--to", "3")
        self.assertEqual((status, len(lines)), (0, 1), lines)
        self.assertNotIn("estimate", lines[0])

    def test_balls_that_never_meet_keep_any_tolerance(self):
        apart = self.level("apart.svg", FLOOR, ball(3, 7.5), ball(13, 7.5))
        status, lines = self.asked("simulate", apart, "1e-8", "--method", "exact", "--to", "2")
        self.assertEqual((status, len(lines)), (0, 1), lines)
        self.assertIn("an estimate", lines[0])

    def test_frames_that_missed_the_tolerance_are_whole_and_a_failure(self):
        heavy = self.level("heavy.svg", FLOOR, ball(8, 7.5, mass=1), ball(8, 6.5, mass=100))
        result = self.smb2d("render", heavy, "-o", "f%02d.png", "--tolerance", "1e-4", "--from", "1.9", "--to", "2",
                            "--fps", "20", "--size", "64x36", "-q")
        self.assertEqual(result.returncode, 1)
        self.assert_one_line(result.stderr)
        self.assertEqual(len(list(self.folder.glob("f*.png"))), 2)


if __name__ == "__main__":
    main()
