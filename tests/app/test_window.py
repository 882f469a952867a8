#!/usr/bin/env python3
"""A real window on a real (virtual) display, played with a real pointer: the ball is dragged, seen and traced."""

import csv
import io
import os
import signal
import subprocess

from program import ASSETS, PATIENCE, ProgramTest, main, until

LEVEL = ASSETS / "levels/01-sunny-hills.svg"
WIDTH, HEIGHT = 960, 540
SCALE = WIDTH / 16  # pixels per metre: a level of 16 m x 9 m is shown whole
START = (1.9, 4.6)  # m, of the ball
TARGET = (3.4, 6.6)  # m, within the spring's reach and in free air


def on_screen(place):
    return round(place[0] * SCALE), round(HEIGHT - place[1] * SCALE)


class Display:
    """An X server of its own, gone when the test is over."""

    def __init__(self, test):
        read, write = os.pipe()
        # Without -noreset it starts anew, and refuses clients meanwhile, whenever its last client leaves.
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-noreset",
                                        "-nolisten", "tcp"], pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        test.addCleanup(self.server.wait)
        test.addCleanup(self.server.terminate)
        with os.fdopen(read) as answer:
            self.name = ":" + answer.readline().strip()

    def run(self, *words):
        return subprocess.run(words, env=dict(os.environ, DISPLAY=self.name), stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, timeout=PATIENCE).stdout


class Window(ProgramTest):
    def open(self, renderer):
        self.display = Display(self)
        self.game = self.start("play", LEVEL, "--renderer", renderer, "--size", f"{WIDTH}x{HEIGHT}",
                               changes={"DISPLAY": self.display.name, "SDL_VIDEODRIVER": "x11"})
        self.window = until(self.find_window, "the window", self.game)
        until(lambda: len(set(self.screenshot())) > 50, "the first picture", self.game)

    def find_window(self):
        found = self.display.run("xdotool", "search", "--onlyvisible", "--pid", str(self.game.pid)).split()
        return found[-1].decode() if found else None

    def screenshot(self):
        """The window's pixels, row by row, as triples."""
        ppm = self.display.run("import", "-silent", "-window", self.window, "-depth", "8", "ppm:-")
        if not ppm.startswith(b"P6"):
            return []
        data = ppm.split(b"\n", 3)[3]
        return [data[i:i + 3] for i in range(0, len(data), 3)]

    def patch(self, place, side=20):
        """The pixels round a place of the world."""
        x, y = on_screen(place)
        pixels = self.screenshot()
        return [pixels[row * WIDTH + column] for row in range(y - side, y + side)
                for column in range(x - side, x + side)] if len(pixels) == WIDTH * HEIGHT else []

    def pointer(self, *words):
        self.display.run("xdotool", *map(str, words))

    def move_to(self, place):
        self.pointer("mousemove", "--window", self.window, *on_screen(place))

    def differs(self, before, place):
        now = self.patch(place)
        return now and sum(a != b for a, b in zip(before, now)) > len(before) / 2

    def drag_the_ball(self):
        air = self.patch(TARGET)
        self.move_to(START)
        self.pointer("mousedown", 1)
        for step in range(1, 11):
            self.move_to(tuple(a + (b - a) * step / 10 for a, b in zip(START, TARGET)))
        until(lambda: self.differs(air, TARGET), "the ball to be seen at the pointer", self.game)
        self.pointer("mouseup", 1)
        until(lambda: not self.differs(air, TARGET), "the ball to fall when it is let go", self.game)

    def save(self):
        self.pointer("key", "--window", self.window, "F5")
        return until(lambda: [path for path in (self.folder / "data").rglob("*.json")
                              if b'"final"' in path.read_bytes()], "the saved run", self.game)[0]

    def close(self):
        self.game.send_signal(signal.SIGTERM)
        self.game.wait(timeout=PATIENCE)

    def trace(self, run, *words):
        return list(csv.DictReader(io.StringIO(self.done("simulate", run, *words).decode())))

    def check_that_the_ball_followed(self, run):
        events = self.trace(run, "--events")
        kinds = [event["event"] for event in events]
        self.assertEqual((kinds.count("grab"), kinds.count("release")), (1, 1))
        grabbed, released = (next(float(e["t"]) for e in events if e["event"] == kind) for kind in ("grab", "release"))
        self.assertLess(grabbed, released)
        rows = [row for row in self.trace(run) if row["ball"] == "0"]
        at = lambda time: max((row for row in rows if float(row["t"]) <= time), key=lambda row: float(row["t"]))
        self.assertAlmostEqual(float(at(grabbed)["x"]), START[0], delta=0.01)
        self.assertAlmostEqual(float(at(released)["x"]), TARGET[0], delta=0.2)
        self.assertAlmostEqual(float(at(released)["y"]), TARGET[1], delta=0.2)

    def test_the_ball_is_dragged_seen_saved_and_verified(self):
        for renderer in ["software", "gl"]:
            with self.subTest(renderer):
                self.open(renderer)
                self.drag_the_ball()
                run = self.save()
                self.close()
                self.check_that_the_ball_followed(run)
                verified = self.smb2d("verify", run)
                self.assertEqual((verified.returncode, verified.stderr), (0, b""), verified.stdout)
                self.done("render", run, "-o", f"{renderer}.png", "-s", "64x36", "--to", "0.1", "--fps", "10")
                run.unlink()

    def test_looking_back_shows_the_past_and_leaves_the_run_as_it_was(self):
        self.open("software")
        air = self.patch(TARGET)
        self.drag_the_ball()
        self.pointer("keydown", "comma")
        until(lambda: self.differs(air, TARGET), "the ball to be back at the pointer", self.game)
        self.pointer("keyup", "comma")
        self.pointer("key", "--window", self.window, "space")
        until(lambda: not self.differs(air, TARGET), "the present to return", self.game)
        run = self.save()
        self.close()
        self.check_that_the_ball_followed(run)
        verified = self.smb2d("verify", run)
        self.assertEqual((verified.returncode, verified.stderr), (0, b""), verified.stdout)

    def test_closing_the_window_ends_the_program(self):
        self.open("software")
        self.pointer("key", "--window", self.window, "q")
        self.assertEqual(self.game.wait(timeout=PATIENCE), 0)

    def test_a_press_beside_the_ball_grabs_nothing(self):
        self.open("software")
        self.move_to(TARGET)
        self.pointer("mousedown", 1)
        self.move_to(START)
        self.pointer("mouseup", 1)
        kinds = [event["event"] for event in self.trace(self.save(), "--events")]
        self.assertNotIn("grab", kinds)


if __name__ == "__main__":
    main()
