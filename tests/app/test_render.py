#!/usr/bin/env python3
"""Picture sequences without a display: names, sizes, counts, bytes (docs/command-line.md)."""

import json
import struct
import subprocess

from program import ASSETS, ProgramTest, files_no_longer_than, main, until

DEMO = ASSETS / "runs/demo.json"
SIZE = ["-s", "128x72"]
ONE_JOB = ["--jobs", "1"]  # each makes a painter of its own, which takes longer than a dozen small pictures
SMALL = [*SIZE, *ONE_JOB]


class Render(ProgramTest):
    def frames(self, folder="."):
        return {path.name: path.read_bytes() for path in sorted((self.folder / folder).glob("*.png"))}

    def test_a_sequence_is_numbered_from_zero_and_has_the_size_asked_for(self):
        self.done("render", DEMO, "-o", "made/for/it/%05d.png", *SIZE, "--to", "0.35", "--fps", "10")
        frames = self.frames("made/for/it")
        self.assertEqual(list(frames), [f"{i:05d}.png" for i in range(4)])  # ceil(3.5)
        for bytes in frames.values():
            self.assertEqual(bytes[:8], b"\x89PNG\r\n\x1a\n")
            self.assertEqual(struct.unpack(">II", bytes[16:24]), (128, 72))

    def test_numbers_start_where_asked_and_a_whole_number_of_frames_is_not_rounded_up(self):
        self.done("render", DEMO, "-o", "f%03d.png", *SMALL, "--to", "0.3", "--fps", "10", "--start-number", "98")
        self.assertEqual(list(self.frames()), ["f098.png", "f099.png", "f100.png"])

    def test_one_frame_needs_no_number(self):
        self.done("render", DEMO, "-o", "one.png", *SMALL, "--to", "0.1", "--fps", "10")
        self.assertEqual(list(self.frames()), ["one.png"])

    def test_many_frames_need_a_number_in_the_name(self):
        self.assert_fails(2, "render", DEMO, "-o", "one.png", *SMALL, "--to", "1", "--fps", "10")
        self.assertEqual(self.frames(), {})

    def test_a_frame_depends_on_its_time_alone(self):
        for what, fps, first, last, whole, words in [
                ("the ball", 5, 5, 10, 2, [DEMO, *SIZE]), ("a tilted stage", 10, 6, 13, 2, [self.tilted_run(), *SIZE]),
                ("the curve of energies", 4, 16, 20, 5, [DEMO, "-s", "640x360", "--overlay", "energy"])]:
            with self.subTest(what):
                words = ["render", *words, "--fps", fps]
                self.done(*words, "-o", f"{what}/all/%d.png", "--jobs", "1", "--to", whole)
                self.done(*words, "-o", f"{what}/late/%d.png", "--jobs", "3", "--from", first / fps, "--to", last / fps,
                          "--start-number", first)
                everything, late = self.frames(f"{what}/all"), self.frames(f"{what}/late")
                self.assertEqual(len(everything), whole * fps)
                self.assertEqual(set(late), {f"{i}.png" for i in range(first, last)})
                self.assertEqual([name for name in late if late[name] != everything[name]], [])

    def tilted_run(self):
        run = {"smb2d": 1, "level": str(ASSETS / "levels/01-sunny-hills.svg"), "duration": 2,
               "inputs": [{"t": 0.5, "tilt": 0.3}, {"t": 1, "tilt": -0.2}]}
        return self.file("tilted.json", json.dumps(run))

    def test_the_picture_turns_with_the_tilt_unless_told_not_to(self):
        run = self.tilted_run()
        for name, words in (("turned", []), ("upright", ["--no-turn"])):
            raw = self.done("render", run, "-o", "-", "-s", "640x360", "--from", "0.95", "--to", "1", "--fps", "10",
                            *ONE_JOB, *words)
            # There is sky beside the upright wall at the level's left end. Turned by 0.3 rad clockwise about a ball
            # at its foot, the wall leans over this pixel: brown in place of blue.
            at = 3 * (640 * 60 + 30)
            red, green, blue = raw[at:at + 3]
            self.assertEqual(red > blue, name == "turned", name)

    def test_the_curve_of_energies_is_drawn(self):
        # The lines of height and of the total stand apart here; nothing else below the table has their colours.
        raw = self.done("render", DEMO, "-o", "-", "-s", "1280x720", "--from", "4", "--to", "4.1", "--fps", "10",
                        "--overlay", "energy")
        pixels = [raw[i:i + 3] for i in range(0, len(raw), 3)]
        below = pixels[1280 * 222:1280 * 318]  # the table of six lines ends at 64 + 150 pixels
        for colour in [b"\xb0\x5b\xe0", b"\x35\xa8\x5b"]:
            self.assertGreater(below.count(colour), 50)

    def test_raw_frames_are_the_pictures_bytes(self):
        words = ["render", DEMO, *SMALL, "--from", "1", "--to", "1.2", "--fps", "10"]
        raw = self.done(*words, "-o", "-")
        self.assertEqual(len(raw), 2 * 128 * 72 * 3)
        self.done(*words, "-o", "%d.png")
        for i in range(2):
            decoded = subprocess.run(["ffmpeg", "-v", "error", "-i", self.folder / f"{i}.png", "-f", "rawvideo",
                                      "-pix_fmt", "rgb24", "-"], stdout=subprocess.PIPE, check=True).stdout
            self.assertEqual(decoded, raw[i * len(decoded):(i + 1) * len(decoded)])

    def test_something_is_drawn_and_moves(self):
        raw = self.done("render", DEMO, "-o", "-", *SMALL, "--from", "1", "--to", "3", "--fps", "1")
        first, second = raw[:128 * 72 * 3], raw[128 * 72 * 3:]
        colours = {first[i:i + 3] for i in range(0, len(first), 3)}
        self.assertGreater(len(colours), 50)
        changed = sum(a != b for a, b in zip(first, second))
        self.assertGreater(changed, 100)
        self.assertLess(changed, len(first) / 2)  # the ball has moved, the level stands still

    def test_fills_follow_the_rule_that_the_drawing_gives(self):
        # Squares of 2.5 m with one of 1 m in their middle, at 8 pixels to the metre; "" is nonzero, as in browsers.
        same_way, other_way = "h1v1h-1z", "v1h1v-1z"
        cases = [(same_way, "", True), (other_way, "", False), (same_way, "nonzero", True),
                 (same_way, "evenodd", False), (other_way, "evenodd", False)]
        left = lambda i: 0.5 + 3.125 * i
        attribute = lambda rule: f'fill-rule="{rule}"' if rule else ""
        squares = [f"""<path class="terrain" fill="red" {attribute(rule)}
            d="M{left(i)} 1h2.5v2.5h-2.5zM{left(i) + 0.75} 1.75{inner}"/>""" for i, (inner, rule, _) in enumerate(cases)]
        level = self.file("fill.svg", f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 9">
            <circle class="ball" cx="2" cy="7" r="0.5"/>{"".join(squares)}</svg>""")
        raw = self.done("render", level, "-o", "-", *SMALL, "--to", "0.01")
        at = lambda x, y: raw[3 * (128 * int(8 * y) + int(8 * x)):][:3]
        earth = b"\xff\x00\x00"
        for i, (inner, rule, filled) in enumerate(cases):
            self.assertEqual(at(left(i) + 0.375, 2.25), earth, (inner, rule))
            self.assertEqual(at(left(i) + 1.25, 2.25) == earth, filled, (inner, rule))

    def test_overlays_are_drawn(self):
        words = ["render", DEMO, "-o", "-", *SMALL, "--from", "5", "--to", "5.1", "--fps", "10"]
        pictures = {self.done(*words, *more) for more in
                    [[], ["--overlay", "figures"], ["--overlay", "forces"], ["--overlay", "energy"],
                     ["--overlay", "all"]]}
        self.assertEqual(len(pictures), 5)

    def test_what_exists_is_not_overwritten_and_looked_for_first(self):
        self.file("2.png", "precious")
        words = ["render", DEMO, "-o", "%d.png", *SMALL, "--to", "0.5", "--fps", "10"]
        self.assert_fails(1, *words, says="2.png")
        self.assertEqual(self.frames(), {"2.png": b"precious"})
        self.done(*words, "--overwrite")
        self.assertEqual(len(self.frames()), 5)
        self.assertNotEqual(self.frames()["2.png"], b"precious")

    def test_a_full_disk_leaves_only_whole_files(self):
        words = ["render", DEMO, "-s", "640x360", "--to", "0.3", "--fps", "10", "--jobs", "1"]
        self.assert_fails(1, *words, "-o", "%d.png", says=".png", preexec_fn=files_no_longer_than(4096))
        self.assertEqual(self.frames(), {})

    def test_a_folder_that_cannot_be_made_is_named(self):
        self.file("taken", "")
        self.assert_fails(1, "render", DEMO, "-o", "taken/%d.png", *SMALL, "--to", "0.1", says="taken")

    def test_an_interrupt_leaves_whole_pictures(self):
        process = self.start("render", DEMO, "-o", "%06d.png", *SIZE, "--to", "100000")
        until(lambda: len(self.frames()) > 2, "the first pictures", process)
        self.assert_interrupted(process)
        for bytes in self.frames().values():
            self.assertEqual(bytes[-8:-4], b"IEND")
        self.assertEqual([path.name for path in self.folder.iterdir() if path.suffix not in (".png", ".svg")], [])


if __name__ == "__main__":
    main()
