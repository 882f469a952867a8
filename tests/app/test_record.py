#!/usr/bin/env python3
"""Videos without a display: whole, playable, honest when cut short (docs/command-line.md)."""

import array
import os
import shutil
import signal
import subprocess
import wave
from pathlib import Path

from program import ASSETS, SANITIZED, SMALL_LEVEL, ProgramTest, files_no_longer_than, main, until

DEMO = ASSETS / "runs/demo.json"
ONE_JOB = ["--jobs", "1"]  # each makes a painter of its own, which takes longer than a dozen small frames
SIZE = ["-s", "128x72", *ONE_JOB]
FRAMES = 20
FILM = ["-s", "160x90", "--to", "4", "--fps", "5", *ONE_JOB]  # four fragments
PICTURE = ["-select_streams", "v"]
ENDINGS = ["mp4"] if SANITIZED else ["mp4", "mkv"]
FULL_DISKS = slice(-1, None) if SANITIZED else slice(None)


class Record(ProgramTest):
    def test_a_video_has_every_frame_says_its_colours_and_begins_with_its_sound(self):
        for name in ["demo.mp4", "into/a/folder/demo.mkv"]:
            self.done("record", DEMO, "-o", name, "-s", "128x72", "--to", "0.5", "--fps", "25")
            self.assertEqual(self.frames_in(name), 13)  # ceil(12.5)
            self.assertEqual(self.probed(name, "width,height,r_frame_rate", *PICTURE), ["128", "72", "25/1"])
            self.assertEqual(self.probed(name, "color_range,color_space,color_transfer,color_primaries", *PICTURE),
                             ["tv", "bt709", "bt709", "bt709"])
            self.assertEqual(self.probed(name, "codec_type"), ["video", "audio"])
            picture, sound = map(float, self.probed(name, "start_time"))
            # AAC begins with 1024 samples that say nothing.
            self.assertAlmostEqual(sound + 1024 / 48000, picture, delta=0.001)
        self.assert_no_files("*part*")

    def test_a_silent_film_has_no_sound(self):
        for name in ["v.mp4", "v.mkv"]:
            self.done("record", DEMO, "-o", name, *SIZE, "--to", "0.5", "--fps", "10", "--no-sound")
            self.assertEqual(self.probed(name, "codec_type"), ["video"])

    def sound(self, name):
        """Rate, and the numbers of both sides in turn."""
        with wave.open(str(self.folder / name)) as file:
            self.assertEqual((file.getnchannels(), file.getsampwidth()), (2, 2))
            numbers = array.array("h", file.readframes(file.getnframes()))
            return file.getframerate(), numbers

    def test_sound_alone_is_as_long_as_the_film_and_needs_no_encoder(self):
        for rate, to, samples in [("60", "0.5", 24000), ("25", "0.5", 13 * 1920), ("30000/1001", "1", 48048)]:
            self.done("record", DEMO, "-o", "v.wav", "--fps", rate, "--to", to, "--overwrite",
                      changes={"PATH": str(self.folder)})
            self.assertEqual((self.sound("v.wav")[0], len(self.sound("v.wav")[1])), (48000, 2 * samples))
        self.assert_no_files("*part*")

    def test_sound_from_a_time_on_is_that_part_of_the_whole(self):
        self.done("record", DEMO, "-o", "whole.wav", "--to", "6")
        self.done("record", DEMO, "-o", "part.wav", "--from", "4.5", "--to", "6", "--fps", "7")
        whole, part = self.sound("whole.wav")[1], self.sound("part.wav")[1]
        self.assertGreater(max(part), 1000)
        self.assertEqual(whole[2 * 216000:], part[:len(whole) - 2 * 216000])

    def test_a_landing_is_heard_at_its_time(self):
        falling = self.file("falling.svg", SMALL_LEVEL.replace('cy="3.5"', 'cy="2.5"'))
        self.done("record", falling, "-o", "v.wav", "--to", "1")
        # The tune is quieter than this, and the fall takes sqrt(2 h / g).
        numbers = self.sound("v.wav")[1][::2]
        loud = next(i for i, number in enumerate(numbers) if abs(number) > 4000)
        self.assertAlmostEqual(loud / 48000, (2 / 9.81) ** 0.5, delta=0.003)

    def test_sound_that_cannot_be_written_is_a_failure(self):
        self.assert_fails(2, "record", DEMO, "-o", "v.wav", "--no-sound")
        self.assert_fails(2, "record", DEMO, "-o", "v.wav", "--to", "30000")  # beyond 32 bits
        old = self.file("v.wav", "precious")
        self.assert_fails(1, "record", DEMO, "-o", "v.wav", says="v.wav")
        self.assert_fails(1, "record", DEMO, "-o", "v.wav", "--overwrite", says="v.part.wav",
                          preexec_fn=files_no_longer_than(100000))
        self.assertEqual(old.read_text(), "precious")
        self.assertGreater(len(self.sound("v.part.wav")[1]), 40000)
        old.unlink()
        self.assert_fails(1, "record", DEMO, "-o", "v.wav", says="v.wav", preexec_fn=files_no_longer_than(20))
        self.assert_no_files("v*")

    def test_sound_cut_short_plays_as_far_as_it_goes(self):
        process = self.start("record", DEMO, "-o", "v.wav", "--to", "20000")
        part = self.folder / "v.part.wav"
        until(lambda: part.exists() and part.stat().st_size > 200000, "the first samples", process)
        self.assert_interrupted(process, "v.part.wav")
        self.assertEqual(4 * (len(self.sound("v.part.wav")[1]) // 2), part.stat().st_size - 44)
        self.assertFalse((self.folder / "v.wav").exists())

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
        result = self.smb2d("record", DEMO, "-o", "v.mp4", "-s", "127x71", "--to", "0.1", *ONE_JOB)
        self.assertEqual(result.returncode, 0)
        self.assert_one_line(result.stderr, "128x72")
        self.assertEqual(self.probed("v.mp4", "width,height", *PICTURE), ["128", "72"])

    def test_another_ending_is_wrong_usage(self):
        self.assert_fails(2, "record", DEMO, "-o", "v.avi")
        self.assert_fails(2, "record", DEMO, "-o", "v")

    def test_what_exists_is_not_overwritten(self):
        old = self.file("v.mp4", "precious")
        self.assert_fails(1, "record", DEMO, "-o", "v.mp4", *SIZE, "--to", "0.1", says="v.mp4")
        self.assertEqual(old.read_text(), "precious")
        self.done("record", DEMO, "-o", "v.mp4", *SIZE, "--to", "0.1", "--overwrite")
        self.assertEqual(self.frames_in("v.mp4"), 6)

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
            # More than a pipe holds by itself.
            self.assert_fails(1, "record", DEMO, "-o", "v.mp4", *SIZE, "--to", "0.5", "--fps", "20",
                              changes=self.imposter(script))
            self.assertFalse((self.folder / "v.mp4").exists(), script)

    def test_a_full_disk_is_a_failure_and_what_was_whole_stays(self):
        old = self.file("v.mp4", "precious")
        self.assert_fails(1, "record", DEMO, "-o", "v.mp4", *FILM, "--overwrite",
                          preexec_fn=files_no_longer_than(20000))
        self.assertEqual(old.read_text(), "precious")

    def assert_plays(self, name):
        """And without a word of complaint; the number of its frames."""
        said = subprocess.run(["ffmpeg", "-v", "error", "-i", self.folder / name, "-f", "null", "-"],
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        self.assertEqual((said.returncode, said.stderr), (0, b""))
        return self.frames_in(name)

    def assert_full_disk_is_told(self, name, **options):
        result = self.assert_fails(1, "record", DEMO, "-o", name, *FILM, says=name, **options)
        self.assertFalse((self.folder / name).exists())
        part = Path(name).with_suffix(".part" + Path(name).suffix)
        # The encoder's own words may name the part too, be it there or not.
        self.assertEqual((self.folder / part).exists(), f"is in {part}" in result.stderr.decode())
        if (self.folder / part).exists():
            plays = self.assert_plays(part)
            self.assertTrue(0 < plays <= FRAMES, plays)
            (self.folder / part).unlink()
            return True
        return False

    sizes = {}  # of whole films, by ending

    def size_of_film(self, ending):
        if ending not in self.sizes:
            film = self.folder / f"whole.{ending}"
            self.done("record", DEMO, "-o", film, *FILM)
            self.sizes[ending] = film.stat().st_size
            film.unlink()
        return self.sizes[ending]

    def test_a_disk_that_is_really_full_is_a_failure_whatever_the_encoder_says(self):
        disk = self.folder / "disk"
        disk.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", disk], stderr=subprocess.DEVNULL)
        if mounted.returncode != 0:
            self.skipTest("a small file system cannot be mounted here")
        self.addCleanup(subprocess.run, ["umount", disk], check=True)
        for ending in ENDINGS:
            size = self.size_of_film(ending)
            left = []
            for room in [0, size // 3, size - 4097][FULL_DISKS]:  # the last lacks no more than the film's end
                filler = disk / "filler"
                filler.write_bytes(bytes((1 << 20) - (room + 4095) // 4096 * 4096))
                left.append(self.assert_full_disk_is_told(f"disk/v.{ending}"))
                filler.unlink()
            self.assertEqual(left[0], SANITIZED)
            self.assertEqual(left[-1], True)

    def test_a_file_that_may_not_grow_is_a_failure_whatever_the_encoder_says(self):
        for ending in ENDINGS:
            size = self.size_of_film(ending)
            for blocks in range(0, size // 512, max(1, size // 512 // 3))[FULL_DISKS]:
                real = shutil.which("ffmpeg")
                limited = self.imposter(f"trap '' XFSZ; ulimit -f {blocks}; exec {real} \"$@\"")
                self.assert_full_disk_is_told(f"v.{ending}", changes=limited)

    def encoder_of(self, process):
        children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
        return int(children[0]) if children else None

    def test_what_a_killed_encoder_leaves_plays(self):
        for ending in ENDINGS:
            part = self.folder / f"v.part.{ending}"
            process = self.start("record", DEMO, "-o", f"v.{ending}", *SIZE, "--to", "100000", "--fps", "10")
            until(lambda: part.exists() and part.stat().st_size > 30000, "the first fragments", process)
            os.kill(self.encoder_of(process), signal.SIGKILL)
            self.assert_ends(process, 1, part.name)
            self.assertGreater(self.assert_plays(part.name), 0)

    def test_what_an_encoder_that_is_killed_at_once_leaves_is_removed(self):
        for ending in ENDINGS:
            process = self.start("record", DEMO, "-o", f"v.{ending}", "-s", "1920x1080", "--to", "100000")
            os.kill(until(lambda: self.encoder_of(process), "the encoder", process), signal.SIGKILL)
            said = self.assert_ends(process, 1, f"v.{ending}")
            for part in self.folder.glob("v.*"):
                self.assertIn(part.name, said)
                self.assert_plays(part.name)

    def test_a_video_cut_short_plays_as_far_as_it_goes(self):
        process = self.start("record", DEMO, "-o", "v.mp4", *SIZE, "--to", "100000", "--fps", "10")
        part = self.folder / "v.part.mp4"
        until(lambda: part.exists() and part.stat().st_size > 20000, "the first fragments", process)
        self.assert_interrupted(process, "v.part.mp4")
        self.assertGreater(self.frames_in("v.part.mp4"), 0)
        self.assertFalse((self.folder / "v.mp4").exists())


if __name__ == "__main__":
    main()
