#!/usr/bin/env python3
"""Exit statuses and the one line that goes with each failure, whatever the subcommand (docs/command-line.md)."""

import subprocess

from program import BINARY, ProgramTest, main

SUBCOMMANDS = ["play", "render", "record", "simulate", "check", "verify", "levels"]
WITH_A_FILE = ["play", "render", "record", "simulate", "check", "verify"]


class Usage(ProgramTest):
    def output_for(self, subcommand):
        return {"render": ["-o", "f%03d.png"], "record": ["-o", "v.mp4"]}.get(subcommand, [])

    def test_every_subcommand_has_help_with_an_example(self):
        for subcommand in SUBCOMMANDS:
            text = self.done(subcommand, "--help").decode()
            self.assertEqual(text.lower().count("example"), 1, text)
            self.assertIn(f"smb2d {subcommand}", text)

    def test_the_programs_own_help_names_every_subcommand(self):
        text = self.done("--help").decode()
        for subcommand in SUBCOMMANDS:
            self.assertIn(subcommand, text)

    def test_an_unknown_option_is_wrong_usage(self):
        for subcommand in SUBCOMMANDS:
            self.assert_fails(2, subcommand, "--no-such-option", self.small_level, *self.output_for(subcommand))

    def test_an_unknown_subcommand_is_wrong_usage(self):
        self.assert_fails(2, "dance", says="dance")

    def test_a_file_that_is_needed_is_named_in_the_usage(self):
        for subcommand in ["render", "record", "simulate", "check", "verify"]:
            self.assert_fails(2, subcommand, *self.output_for(subcommand))

    def test_a_missing_file_fails_and_is_named(self):
        for subcommand in ["play", "render", "record", "simulate"]:
            self.assert_fails(1, subcommand, "nowhere.svg", *self.output_for(subcommand), says="nowhere.svg")
            self.assert_fails(1, subcommand, "nowhere.json", *self.output_for(subcommand), says="nowhere.json")

    def test_a_broken_level_fails_with_its_file_and_line(self):
        self.file("broken.svg", self.small_level.read_text().replace('r="0.5"', 'r="-1"'))
        for subcommand in ["play", "render", "record", "simulate"]:
            self.assert_fails(1, subcommand, "broken.svg", *self.output_for(subcommand), says="broken.svg:3: ")
        self.assert_no_files("v*.mp4")

    def test_options_are_free_of_order(self):
        first = self.done("simulate", "--to", "0.1", self.small_level)
        self.assertEqual(first, self.done("simulate", self.small_level, "--to", "0.1"))

    def test_numbers_that_cannot_be_meant_are_wrong_usage(self):
        for words in [["--to", "-1"], ["--to", "soon"], ["--to", "nan"], ["--to", "inf"], ["--every", "0"],
                      ["--every", "-1/24"], ["--every", "1/0"], ["--rate", "0"], ["--rate", "-5"], ["--rate", "x"],
                      ["--method", "guess"], ["--tolerance", "0"], ["--tolerance", "-1e-3"], ["--tolerance", "nan"],
                      ["--tolerance", "inf"], ["--tolerance", "deep"], ["--format", "xml"], ["--to"]]:
            self.assert_fails(2, "simulate", self.small_level, *words)
        for words in [["-s", "0x90"], ["-s", "wide"], ["-s", "160"], ["-r", "0"], ["--fps", "-1"], ["--jobs", "0"],
                      ["--overlay", "nonsense"], ["--from", "-1"]]:
            self.assert_fails(2, "render", self.small_level, "-o", "f%03d.png", *words)
        self.assert_fails(2, "play", self.small_level, "--renderer", "crayon")

    def test_more_rows_or_frames_than_anybody_can_want_are_wrong_usage_that_names_the_option(self):
        self.file("long.json", '{"smb2d": 1, "level": "small.svg", "duration": 5e8, "inputs": []}')
        for words in [[self.small_level, "--every", "1e-18"], [self.small_level, "--every", "1e-9", "--to", "1.1"],
                      ["long.json", "--every", "1/3"]]:
            self.assert_fails(2, "simulate", *words, says="--every")
        self.done("simulate", self.small_level, "--every", "1e-18", "--events", "--to", "0.1")
        for command, output in [("render", "f%03d.png"), ("record", "v.mp4")]:
            self.assert_fails(2, command, self.small_level, "-o", output, "--fps", "1e12", says="--fps")
        self.assert_fails(2, "render", "long.json", "-o", "f%03d.png", "--fps", "3", says="--fps")

    def test_a_class_a_letter_from_a_role_is_a_warning_of_every_command(self):
        text = self.small_level.read_text().replace("</svg>", '<circle class="bal" cx="5" cy="2" r="0.2"/></svg>')
        level = self.file("odd.svg", text)
        run = self.file("odd.json", '{"smb2d": 1, "level": "odd.svg", "duration": 0.1, "inputs": []}')
        plain = self.done("simulate", self.small_level, "--to", "0.1")
        sequence = ["-s", "64x36", "--to", "0.1", "--fps", "10"]
        for words in [["simulate", level, "--to", "0.1"], ["simulate", run], ["verify", run],
                      ["render", level, "-o", "a.png", *sequence], ["record", level, "-o", "a.mp4", *sequence]]:
            result = self.smb2d(*words)
            self.assert_one_line(result.stderr, "odd.svg:3: warning: circle: class bal is a letter away from ball")
            self.assertEqual(result.returncode, 0)
            if words[0] == "simulate":
                self.assertEqual(result.stdout, plain)
        self.done("render", level, "-o", "b.png", *sequence, "--quiet")
        self.assertIn(b"warning: circle: class bal", self.done("check", level))

    def test_a_misspelt_ball_is_told_in_the_line_of_the_failure(self):
        self.file("none.svg", self.small_level.read_text().replace('class="ball"', 'class="bal"'))
        for subcommand in ["play", "render", "record", "simulate"]:
            self.assert_fails(1, subcommand, "none.svg", *self.output_for(subcommand),
                              says="there must be a ball; line 3: circle: class bal is a letter away from ball")

    def test_a_thread_that_cannot_be_started_is_one_line(self):
        with open(BINARY, "rb") as binary:
            is_sanitized = b"__asan_init" in binary.read()
        if is_sanitized:
            self.skipTest("the address sanitizer wants terabytes of addresses for itself")
        # So little that some threads of eight megabytes of stack fit and not all of 256.
        def little_memory():
            import resource

            resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))

        for words in [["render", "-o", "f%04d.png"], ["record", "-o", "v.mp4"]]:
            self.assert_fails(1, words[0], self.small_level, *words[1:], "-s", "64x36", "--to", "10", "--jobs", "256",
                              says="--jobs 256: thread ", preexec_fn=little_memory)
        self.assert_no_files("f*.png")
        self.assert_no_files("v*.mp4")

    def test_what_is_chosen_for_a_tolerance_is_said_on_standard_error_and_nothing_else_is(self):
        asked = self.smb2d("simulate", self.small_level, "--to", "0.1", "--tolerance", "1e-6")
        self.assertEqual((asked.returncode, asked.stdout), (0, self.done("simulate", self.small_level, "--to", "0.1")))
        self.assertRegex(asked.stderr.decode(), r"^smb2d: .*: method exact: [^\n]*\n$")
        for method in [[], ["--method", "exact", "--tolerance", "1e-6"]]:
            self.assertEqual(self.smb2d("simulate", self.small_level, "--to", "0.1", *method).stderr, b"")

    def test_a_tolerance_raises_the_rate_of_steps_unless_that_is_named_and_leaves_exact_as_it_is(self):
        # The error falls with the square of the step: a hundredth of the usual 2.5e-5 m asks for ten times 240 Hz.
        # One ball is stepped at no rate: these two lean. (1: they overlap by more than the tolerance.)
        two = self.file("two.svg", self.small_level.read_text().replace(
            '<circle class="ball" cx="2"', '<circle class="ball" cx="2.5" cy="2.6" r="0.5"/><circle class="ball" cx="2"'))

        def trace(*words, level=two):
            result = self.smb2d("simulate", level, "--to", "1", *words)
            self.assertIn(result.returncode, [0, 1], result.stderr)
            return result.stdout

        self.assertEqual(trace("--method", "steps", "--tolerance", "2.5e-7"),
                         trace("--method", "steps", "--rate", "2400"))
        self.assertNotEqual(trace("--method", "steps", "--rate", "2400"), trace("--method", "steps"))
        self.assertEqual(trace("--method", "steps", "--tolerance", "2.5e-7", "--rate", "100"),
                         trace("--method", "steps", "--rate", "100"))
        self.assertEqual(trace("--method", "exact", "--tolerance", "2.5e-7", level=self.small_level),
                         trace(level=self.small_level))
        self.assertEqual(trace("--method", "exact", "--tolerance", "1"), trace("--method", "exact"))
        self.assert_fails(2, "simulate", self.small_level, "--method", "article", "--tolerance", "1e-3", says="article")

    def test_render_and_record_need_an_output(self):
        self.assert_fails(2, "render", self.small_level)
        self.assert_fails(2, "record", self.small_level)

    def test_play_without_a_display_says_so(self):
        self.assert_fails(1, "play", self.small_level)
        self.assert_fails(1, self.small_level)

    def test_a_closed_standard_output_is_a_failure(self):
        for words in [["simulate", self.small_level], ["levels"], ["simulate", "--help"], ["check", self.small_level]]:
            command = ["sh", "-c", '"$@" >&-', "sh", BINARY, *map(str, words)]
            result = subprocess.run(command, stderr=subprocess.PIPE, cwd=self.folder, env=self.environment())
            self.assert_one_line(result.stderr)
            self.assertEqual(result.returncode, 1, words)

    def test_a_full_standard_output_is_a_failure(self):
        with open("/dev/full", "wb") as full:
            for words in [["simulate", self.small_level], ["simulate", self.small_level, "--events"], ["levels"],
                          ["render", self.small_level, "-o", "-", "-s", "64x36", "--to", "0.1"]]:
                self.assert_fails(1, *words, stdout=full)

    def test_a_reader_that_leaves_is_a_failure(self):
        for words in [["simulate", self.small_level, "--to", "10000"],
                      ["render", self.small_level, "-o", "-", "-s", "64x36", "--to", "60"]]:
            process = self.start(*words, stdout=subprocess.PIPE)
            process.stdout.read(100)
            process.stdout.close()
            process.stdout = None
            self.assert_ends(process, 1)

    def test_levels_lists_what_ships_from_wherever_it_is_started(self):
        lines = self.done("levels").decode().splitlines()
        self.assertGreaterEqual(len(lines), 3)
        self.assertIn("Sunny hills", "\n".join(lines))
        positions = ["\n".join(lines).index(title) for title in ["Sunny hills", "The turn", "The big push"]]
        self.assertEqual(positions, sorted(positions))


if __name__ == "__main__":
    main()
