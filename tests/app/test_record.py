#!/usr/bin/env python3
"""Videos without a display: whole, playable, honest when cut short (formats.md section 1)."""

import json
import os
import signal
import subprocess

from program import ASSETS, ProgramTest, files_no_longer_than, main, until

DEMO = ASSETS / "runs/demo.json"
SIZE = ["-s", "128x72"]


class Record(ProgramTest):
    def stream(self, name):
        """What ffprobe says of the video, its frames counted by decoding them."""
        said = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_streams", "-of", "json",
                               self.folder / name], stdout=subprocess.PIPE, check=True).stdout
        return json.loads(said)["streams"][0]

    def test_a_video_has_every_frame_and_says_its_colours(self):
        for name in ["demo.mp4", "into/a/folder/demo.mkv"]:
            self.done("record", DEMO, "-o", name, *SIZE, "--to", "0.5", "--fps", "25")
            stream = self.stream(name)
            self.assertEqual(stream["nb_read_frames"], "13")  # ceil(12.5)
            self.assertEqual((stream["width"], stream["height"]), (128, 72))
            self.assertEqual(stream["r_frame_rate"], "25/1")
            self.assertEqual((stream["color_space"], stream["color_primaries"], stream["color_transfer"],
                              stream["color_range"]), ("bt709", "bt709", "bt709", "tv"))
        self.assert_no_files("*part*")

    def test_the_video_shows_what_the_pictures_show(self):
        words = [DEMO, *SIZE, "--from", "2", "--to", "2.1", "--fps", "10"]
        self.done("record", *words, "-o", "v.mp4")
        picture = self.done("render", *words, "-o", "-")
        shown = subprocess.run(["ffmpeg", "-v", "error", "-i", self.folder / "v.mp4", "-vf",
                                "scale=in_color_matrix=bt709:in_range=tv", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                               stdout=subprocess.PIPE, check=True).stdout
        self.assertEqual(len(shown), len(picture))
        for channel in range(3):  # a lossy coder keeps the mean; the matrix of another standard shifts it by 5 or more
            mean = lambda pixels: sum(pixels[channel::3]) / (len(pixels) / 3)
            self.assertAlmostEqual(mean(shown), mean(picture), delta=2)  # of 255

    def test_an_odd_size_is_rounded_up_with_a_note(self):
        result = self.smb2d("record", DEMO, "-o", "v.mp4", "-s", "127x71", "--to", "0.1")
        self.assertEqual(result.returncode, 0)
        self.assert_one_line(result.stderr, "128x72")
        stream = self.stream("v.mp4")
        self.assertEqual((stream["width"], stream["height"]), (128, 72))

    def test_another_ending_is_wrong_usage(self):
        self.assert_fails(2, "record", DEMO, "-o", "v.avi")
        self.assert_fails(2, "record", DEMO, "-o", "v")

    def test_what_exists_is_not_overwritten(self):
        old = self.file("v.mp4", "precious")
        self.assert_fails(1, "record", DEMO, "-o", "v.mp4", *SIZE, "--to", "0.1", says="v.mp4")
        self.assertEqual(old.read_text(), "precious")
        self.done("record", DEMO, "-o", "v.mp4", *SIZE, "--to", "0.1", "--overwrite")
        self.assertEqual(self.stream("v.mp4")["nb_read_frames"], "6")

    def test_without_ffmpeg_it_says_so(self):
        self.assert_fails(1, "record", DEMO, "-o", "v.mp4", *SIZE, "--to", "0.1", says="ffmpeg",
                          changes={"PATH": str(self.folder)})
        self.assert_no_files("*.mp4")

    def imposter(self, script):
        fake = self.file("bin/ffmpeg", "#!/bin/sh\n" + script + "\n")
        fake.chmod(0o755)
        return {"PATH": f"{fake.parent}:{os.environ['PATH']}"}

    def test_an_encoder_that_dies_is_a_failure(self):
        for script in ["exit 1", "head -c 20000 >/dev/null; exit 0", "kill -9 $$", "cat >/dev/null; exit 0"]:
            self.assert_fails(1, "record", DEMO, "-o", "v.mp4", *SIZE, "--to", "0.5", changes=self.imposter(script))
            self.assertFalse((self.folder / "v.mp4").exists(), script)

    def test_a_full_disk_is_a_failure_and_what_was_whole_stays(self):
        old = self.file("v.mp4", "precious")
        self.assert_fails(1, "record", DEMO, "-o", "v.mp4", "-s", "640x360", "--to", "2", "--overwrite",
                          preexec_fn=files_no_longer_than(20000))
        self.assertEqual(old.read_text(), "precious")

    def test_a_video_cut_short_plays_as_far_as_it_goes(self):
        process = self.start("record", DEMO, "-o", "v.mp4", *SIZE, "--to", "100000")
        part = self.folder / "v.part.mp4"
        until(lambda: part.exists() and part.stat().st_size > 20000, "the first fragments", process)
        process.send_signal(signal.SIGINT)
        _, stderr = process.communicate(timeout=100)
        self.assertEqual(process.returncode, 130)
        self.assert_one_line(stderr, "v.part.mp4")
        self.assertGreater(int(self.stream("v.part.mp4")["nb_read_frames"]), 0)
        self.assertFalse((self.folder / "v.mp4").exists())


if __name__ == "__main__":
    main()
