#!/usr/bin/env python3
"""A real window on a real (virtual) display, played with a real pointer: the ball is dragged, seen and traced."""

import array
import csv
import io
import json
import math
import mmap
import os
import shutil
import signal
import socket
import struct
import subprocess
import tempfile
import time
from pathlib import Path

from program import PATIENCE, SMALL_LEVEL, ProgramTest, main, until

# A ball at rest, and the spring that there is where a level says nothing of it: strong enough to lift the ball.
LEVEL = """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 9"><title>Floor</title>
<path id="floor" class="terrain" d="M -1 4.8 H 20"/>{}
<circle class="ball" cx="1.9" cy="4.4" r="0.4"/></svg>
"""
GOAL = '<rect class="goal" x="5" y="1" width="3" height="3.8"/>'
WIDTH, HEIGHT = 640, 360
SCALE = WIDTH / 16  # pixels per metre: a level of 16 m x 9 m is shown whole
RADIUS = 0.4  # m, of the ball
START = (1.9, 4.6)  # m, of the ball
TARGET = (3.4, 6.6)  # m, within the spring's reach and in free air
RED_FLOOR = SMALL_LEVEL.replace("/>", '/><rect class="terrain" fill="#f00" width="8" height="0.5" y="4"/>', 1)


def on_screen(place):
    return round(place[0] * SCALE), round(HEIGHT - place[1] * SCALE)


class Refused(Exception):
    """An error that the X server answers with."""


class Display:
    """An X server of its own; `clean_up` is given what is to be called when it is needed no more."""

    def __init__(self, clean_up):
        memory = tempfile.mkdtemp(prefix="smb2d-display-")
        clean_up(shutil.rmtree, memory)
        read, write = os.pipe()
        # Without -noreset it starts anew, and refuses clients meanwhile, whenever its last client leaves.
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-noreset",
                                        "-nolisten", "tcp", "-fbdir", memory], pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        clean_up(self.server.wait)
        clean_up(self.server.terminate)
        with os.fdopen(read) as answer:
            self.name = ":" + answer.readline().strip()
        with open(Path(memory, "Xvfb_screen0"), "rb") as file:
            self.memory = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        clean_up(self.memory.close)
        self.client = socket.socket(socket.AF_UNIX)
        clean_up(self.client.close)
        self.client.connect(f"/tmp/.X11-unix/X{self.name[1:]}")
        self.client.sendall(struct.pack("=2B5H", ord("l"), 0, 11, 0, 0, 0, 0))  # version 11, without a name
        welcome, _, _, _, words = struct.unpack("=2B3H", self.receive(8))
        assert welcome == 1, "the X server refuses this client"
        setup = self.receive(4 * words)
        self.resources, = struct.unpack_from("=I", setup, 4)
        vendor, formats = struct.unpack_from("=H", setup, 16)[0], setup[21]
        self.root, = struct.unpack_from("=I", setup, 32 + vendor + -vendor % 4 + 8 * formats)
        self.may_drop, self.events, self.atoms = False, [], {}

    def receive(self, size):
        return self.client.recv(size, socket.MSG_WAITALL)

    def answer(self):
        """Of 32 bytes and what follows them; events that came before it are kept."""
        while True:
            answer = self.receive(32)
            if answer[0] == 1:
                more, = struct.unpack_from("=I", answer, 4)
                return answer + self.receive(4 * more) if more else answer
            if answer[0] == 0:
                raise Refused(answer.hex())
            self.events.append(answer)

    def event(self, kind):
        """The next one of that kind; others before it are lost."""
        while True:
            event = self.events.pop(0) if self.events else self.receive(32)
            if event[0] == 0:
                raise Refused(event.hex())
            if event[0] & 127 == kind:
                return event

    def synchronise(self):
        """Whatever request of another client the server was in the middle of is done."""
        self.client.sendall(struct.pack("=2BH", 43, 0, 1))  # GetInputFocus, as XSync does
        self.answer()

    def pixels(self, left, top, width, height):
        """Of a part of the screen, row by row, as numbers 0xrrggbb. Never half a frame: the same before and after the server
        answers."""
        before, now = None, self.read(left, top, width, height)
        while now != before:
            self.synchronise()
            before, now = now, self.read(left, top, width, height)
        return now

    def read(self, left, top, width, height):
        """Where the server paints, whatever it is in the middle of (xwd, 32 bits a pixel)."""
        header = struct.unpack_from(">25I", self.memory)
        begin, stride = header[0] + 12 * header[19], header[12]
        rows = [begin + y * stride + 4 * left for y in range(top, top + height)]
        return array.array("I", b"".join(self.memory[row:row + 4 * width] for row in rows))

    def ask(self, opcode, detail, body, answers=False):
        """A request of the X protocol; its answer, where it has one."""
        body += bytes(-len(body) % 4)
        self.client.sendall(struct.pack("=2BH", opcode, detail, 1 + len(body) // 4) + body)
        return self.answer() if answers else None

    def atom(self, name):
        if name not in self.atoms:
            answer = self.ask(16, 0, struct.pack("=2H", len(name), 0) + name.encode(), True)
            self.atoms[name], = struct.unpack_from("=I", answer, 8)
        return self.atoms[name]

    def property(self, window, name):
        """Its bytes, none where there is no such property."""
        answer = self.ask(20, 0, struct.pack("=5I", window, self.atom(name), 0, 0, 1024), True)
        return answer[32:32 + answer[1] // 8 * struct.unpack_from("=I", answer, 16)[0]]

    def window_of(self, process):
        """The one that it shows, and its left, top, width and height; None as long as there is none."""
        tree = self.ask(15, 0, struct.pack("=I", self.root), True)
        for window in struct.unpack_from(f"={struct.unpack_from('=H', tree, 16)[0]}I", tree, 32):
            try:
                is_seen = self.ask(3, 0, struct.pack("=I", window), True)[26] == 2
                if is_seen and self.property(window, "_NET_WM_PID") == struct.pack("=I", process.pid):
                    return window, list(struct.unpack_from("=2h2H", self.ask(14, 0, struct.pack("=I", window), True), 12))
            except Refused:  # another program's, gone meanwhile
                pass
        return None

    def begin(self):
        """As after the start: the pointer in the middle, keys for the window below it."""
        self.ask(42, 0, struct.pack("=2I", 1, 0))
        self.ask(41, 0, struct.pack("=2I2h2H2h", 0, self.root, 0, 0, 0, 0, 640, 400))
        self.synchronise()

    def send_event(self, window, event):
        self.ask(25, 0, struct.pack("=2I", window, 0) + event)

    def drop(self, path, window):
        """On the middle of the window, as file managers do (XDND 5): enter, position, drop; then the target asks this client
        for the list of files, as the owner of a selection."""
        here, text = self.resources, path.as_uri().encode() + b"\r\n"
        if not self.may_drop:
            self.ask(1, 0, struct.pack("=2I6H2I", here, self.root, 0, 0, 1, 1, 0, 0, 0, 0))  # a window, never shown
            self.may_drop = True
        selection, files = self.atom("XdndSelection"), self.atom("text/uri-list")
        self.ask(22, 0, struct.pack("=3I", here, selection, 0))
        message = lambda name, *data: self.send_event(
            window, struct.pack("=2BH2I5I", 33, 32, 0, window, self.atom(name), here, *data))
        message("XdndEnter", 5 << 24, files, 0, 0)
        message("XdndPosition", 0, 320 << 16 | 180, 0, self.atom("XdndActionCopy"))
        message("XdndDrop", 0, 0, 0, 0)
        self.client.settimeout(PATIENCE)
        at, _, asking, _, target, place = struct.unpack_from("=6I", self.event(30), 4)  # SelectionRequest
        self.ask(18, 0, struct.pack("=3IB3xI", asking, place, target, 8, len(text)) + text)  # ChangeProperty
        self.send_event(asking, struct.pack("=2BH5I8x", 31, 0, 0, at, asking, selection, target, place))
        finished = self.atom("XdndFinished")
        while struct.unpack_from("=I", self.event(33), 8)[0] != finished:  # the status comes before it
            pass
        self.client.settimeout(None)

    def run(self, *words):
        return subprocess.run(words, env=dict(os.environ, DISPLAY=self.name), stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, timeout=PATIENCE).stdout


class Window(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.display = Display(cls.addClassCleanup)

    def setUp(self):
        super().setUp()
        self.display.begin()
        # After the program's end: whatever a test that failed has held down.
        self.addCleanup(self.pointer, "mouseup", 1, "keyup", "comma", "keyup", "Right")

    def open(self, renderer, *files):
        """Without files: the level above."""
        files = files or [self.file("floor.svg", LEVEL.format(""))]
        self.play(*files, renderer=renderer)

    def play(self, *files, renderer="software", size=f"{WIDTH}x{HEIGHT}", **changes):
        """Files, and options; without files, the title."""
        self.game = self.start("play", *files, "--renderer", renderer, "--size", size,
                               changes={"DISPLAY": self.display.name, "SDL_VIDEODRIVER": "x11", "LC_ALL": "C", **changes})
        window, self.place = until(lambda: self.display.window_of(self.game), "the window", self.game)
        self.window = str(window)
        until(self.is_painted, "the first picture", self.game)

    def is_painted(self):
        left, top, width, height = self.place
        return len(set(self.display.pixels(left + width // 2 - 16, top, 32, height))) > 50

    def screenshot(self):
        """The window's pixels, row by row."""
        return self.display.pixels(*self.place)

    def wait_until_still(self, what):
        """Nothing moves for a third of a second."""
        before, since = self.screenshot(), time.monotonic()

        def is_still():
            nonlocal before, since
            now = self.screenshot()
            if now != before:
                before, since = now, time.monotonic()
            return time.monotonic() > since + 0.33

        until(is_still, what, self.game)

    def patch(self, place, side=20):
        """The pixels round a place of the world."""
        x, y = on_screen(place)
        return self.display.pixels(self.place[0] + x - side, self.place[1] + y - side, 2 * side, 2 * side)

    def pointer(self, *words):
        self.display.run("xdotool", *map(str, words))

    def move_to(self, place):
        self.pointer("mousemove", "--window", self.window, *on_screen(place))

    def press_at(self, place):
        self.move_to(place)
        self.pointer("mousedown", 1)

    def drag(self, start, end):
        self.press_at(start)
        self.move_to(end)
        self.pointer("mouseup", 1)

    def click(self, x, y):
        """Pixels."""
        self.pointer("mousemove", "--window", self.window, round(x), round(y), "click", 1)

    def differs(self, before, place):
        now = self.patch(place)
        return sum(a != b for a, b in zip(before, now)) > len(before) / 2

    def drag_the_ball(self):
        air = self.patch(TARGET)
        self.press_at(START)
        for step in range(1, 11):
            self.move_to(tuple(a + (b - a) * step / 10 for a, b in zip(START, TARGET)))
        until(lambda: self.differs(air, TARGET), "the ball to be seen at the pointer", self.game)
        self.pointer("mouseup", 1)
        until(lambda: not self.differs(air, TARGET), "the ball to fall when it is let go", self.game)

    def press_key(self, key):
        self.pointer("key", "--window", self.window, key)

    def save(self, key="F5"):
        self.press_key(key)
        return until(lambda: [path for path in (self.folder / "data").rglob("*.json")
                              if b'"final"' in path.read_bytes()], "the saved run", self.game)[0]

    def so_far(self):
        """The run until now."""
        file = self.save()
        run = json.loads(file.read_text())
        file.unlink()
        return run

    def close(self):
        self.game.send_signal(signal.SIGTERM)
        self.game.wait(timeout=PATIENCE)

    def last_words(self, status):
        """Of a game that ends with the status."""
        _, stderr = self.game.communicate(timeout=PATIENCE)
        self.assertEqual(self.game.returncode, status, stderr)
        return stderr

    def trace(self, run, *words):
        return list(csv.DictReader(io.StringIO(self.done("simulate", run, *words).decode())))

    def times_of(self, kind, run):
        return [float(event["t"]) for event in self.trace(run, "--events") if event["event"] == kind]

    def assert_grabs(self, run, count):
        """So many, and as many releases."""
        self.assertEqual([len(self.times_of(kind, run)) for kind in ("grab", "release")], [count, count])

    def check_that_the_ball_followed(self, run):
        (grabbed,), (released,) = (self.times_of(kind, run) for kind in ("grab", "release"))
        self.assertLess(grabbed, released)
        rows = [row for row in self.trace(run) if row["ball"] == "0"]
        at = lambda time: max((row for row in rows if float(row["t"]) <= time), key=lambda row: float(row["t"]))
        self.assertAlmostEqual(float(at(grabbed)["x"]), START[0], delta=0.01)
        # It was let go once it covered half of a square about the target: no disc does that without its middle.
        way = [float(at(released)[axis]) - target for axis, target in zip("xy", TARGET)]
        self.assertLess(math.hypot(*way), RADIUS)

    def check_the_run(self, run):
        self.check_that_the_ball_followed(run)
        self.done("verify", run)

    def test_the_ball_is_dragged_seen_saved_and_verified_by_a_graphics_card(self):
        self.open("gl")
        self.drag_the_ball()
        run = self.save()
        self.close()
        self.check_the_run(run)
        self.done("render", run, "-o", "frame.png", "-s", "64x36", "--to", "0.1", "--fps", "10")

    def test_the_ball_is_dragged_and_looking_back_shows_the_past_and_leaves_the_run_as_it_was(self):
        self.open("software")
        self.drag_the_ball()
        run = self.save()
        self.check_the_run(run)
        self.done("render", run, "-o", "frame.png", "-s", "64x36", "--to", "0.1", "--fps", "10")
        run.unlink()
        empty = self.patch(START)
        self.pointer("keydown", "comma")
        until(lambda: self.differs(empty, START), "the ball to be back where it began", self.game)
        self.pointer("keyup", "comma")
        self.press_key("space")
        until(lambda: not self.differs(empty, START), "the present to return", self.game)
        run = self.save()
        self.close()
        self.check_the_run(run)

    def inputs(self, run):
        return json.loads(run.read_text())["inputs"]

    def test_the_pointer_is_where_it_is_seen_to_be_while_the_picture_is_turned(self):
        # A ball wedged in a notch of 45 degrees, which neither the tilt nor the weak spring gets out of it: it stays
        # where the picture turns about it.
        ball = (8, 2 + 0.4 * math.sqrt(2))
        level = self.file("notch.svg", """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 9"
            data-tilt-limit="0.3" data-drag-frequency="0.3"><title>Notch</title>
            <path class="terrain" d="M -1 5 H 6 L 8 7 L 10 5 H 17"/>
            <circle class="ball" cx="8" cy="{}" r="0.4"/></svg>""".format(9 - ball[1]))
        self.open("software", level)
        edge = (2, 4.6)  # sky, above ground that rises a tenth of its distance
        before = self.patch(edge)
        self.pointer("keydown", "Right")
        until(lambda: self.differs(before, edge), "the picture to turn", self.game)
        self.drag(ball, (ball[0] + 1, ball[1]))  # a metre to the right on the screen
        inputs = self.so_far()["inputs"]
        tilts = [(0, 0)] + [(i["t"], i["tilt"]) for i in inputs if "tilt" in i]

        def turn(time):
            """The mean over half a second by the kernel 12 u (1 - u)^2 (docs/game.md)."""
            mean = 0
            for (_, before), (since, after) in zip(tilts, tilts[1:]):
                u = min(max((time - since) / 0.5, 0), 1)
                mean += (after - before) * u * u * (6 - 8 * u + 3 * u * u)
            return mean

        last = [i for i in inputs if "move" in i][-1]
        angle = turn(last["t"])
        self.assertGreater(angle, 0.04)  # twice as far as what is compared may differ
        self.assertAlmostEqual(last["move"]["x"], ball[0] + math.cos(angle), delta=0.02)
        self.assertAlmostEqual(last["move"]["y"], ball[1] + math.sin(angle), delta=0.02)

    def test_losing_the_focus_lets_go_of_the_ball_and_pauses(self):
        self.open("software")
        self.pointer("windowfocus", "--sync", self.window)
        air = self.patch(TARGET)
        self.press_at(START)
        self.move_to(TARGET)
        until(lambda: self.differs(air, TARGET), "the ball to be seen at the pointer", self.game)
        self.pointer("windowfocus", 0)  # nobody's
        paused = self.so_far()
        self.assertIn("release", paused["inputs"][-1])
        self.assertTrue(self.differs(air, TARGET))  # it hangs in the air
        self.assertEqual(self.so_far()["duration"], paused["duration"])
        self.move_to(START)  # the button is still down
        self.pointer("mouseup", 1)
        self.pointer("windowfocus", "--sync", self.window)
        self.press_key("space")
        until(lambda: not self.differs(air, TARGET), "the ball to fall when the game goes on", self.game)
        self.move_to(TARGET)
        run = self.save()
        self.close()
        self.assert_grabs(run, 1)
        self.assertIn("release", self.inputs(run)[-1])
        self.done("verify", run)

    def test_the_hook_goes_along_while_the_pointer_is_held_still_beyond_the_reach(self):
        self.open("software")
        far = (12.5, 7)  # where the ball comes to it, it is still well in sight
        self.press_at(START)
        self.move_to(far)
        until(lambda: sum("move" in entry for entry in self.so_far()["inputs"]) > 10, "the hook to go along", self.game)
        self.pointer("mouseup", 1)
        run = self.save()
        self.close()
        still = [entry for entry in self.inputs(run) if entry.get("move") == self.inputs(run)[-2]["move"]][1:-1]
        self.assertGreater(len(still), 5)
        moments = [round(entry["t"] * 60) for entry in still]
        self.assertEqual([entry["t"] for entry in still], [moment / 60 for moment in moments])
        self.assertEqual(moments, list(range(moments[0], moments[-1] + 1)))  # none is left out
        self.done("verify", run)

    def test_a_spoilt_list_of_best_times_is_set_aside_with_one_message(self):
        best = self.file("data/smb2d/best.json", '{"00000000000000')
        level = self.file("over.svg", SMALL_LEVEL.replace("</svg>", '<line class="goal" x1="2.2" x2="2.2" y2="4"/></svg>'))
        self.open("software", level)
        self.press_key("space")
        aside = best.with_name("best.json.spoilt")
        until(lambda: aside.exists() and best.exists(), "the best time to be kept", self.game)
        self.assertEqual(aside.read_text(), '{"00000000000000')
        self.assertEqual(len(json.loads(best.read_text())), 1)
        self.game.send_signal(signal.SIGTERM)
        _, stderr = self.game.communicate(timeout=PATIENCE)
        said = [line for line in stderr.decode().splitlines() if "best times" in line]
        self.assertEqual(len(said), 1, stderr)
        self.assertIn("best.json.spoilt", said[0])

    def open_drawing(self, text):
        self.level = self.file("drawn.svg", text)
        self.play(self.level, size="320x180")
        self.until_colour(0xff0000)

    def save_drawing(self, text):
        """As editors do: beside it, then renamed."""
        self.file("drawn.svg.new", text).replace(self.level)

    def until_colour(self, colour):
        until(lambda: self.screenshot().count(colour) > 1000, f"terrain of colour {colour:06x}", self.game)

    def test_a_saved_change_of_the_level_is_read_at_once_and_a_fault_told_while_the_last_good_level_plays_on(self):
        self.open_drawing(RED_FLOOR)
        self.save_drawing(RED_FLOOR.replace("#f00", "#00f"))
        self.until_colour(0x0000ff)
        self.level.write_text(RED_FLOOR.replace("#f00", "#0f0"))  # in place
        self.until_colour(0x00ff00)
        self.save_drawing(RED_FLOOR.replace('r="0.5"', 'r="-1"'))
        line = self.game.stderr.readline().decode()
        self.assertRegex(line, r"drawn\.svg:3: ball: r must be greater than 0, got -1$")
        self.save_drawing(RED_FLOOR.replace('r="0.5"', 'r="-1" data-mass="0"'))
        line = self.game.stderr.readline().decode()
        self.assertRegex(line, r"drawn\.svg:3: ball: .*, and 1 more \(smb2d check\)$")
        self.until_colour(0x00ff00)
        self.save_drawing(RED_FLOOR.replace("#f00", "#00f"))
        self.until_colour(0x0000ff)
        self.close()

    def test_the_world_waits_for_the_first_input_and_runs_begin_there(self):
        falling = LEVEL.format("").replace('cy="4.4"', 'cy="3"')
        self.open("software", self.file("falling.svg", falling))
        self.pointer("keydown", "F1")  # nothing of these is an input
        self.pointer("keyup", "F1")
        self.press_key("F1")
        self.assertEqual(self.so_far()["duration"], 0)
        self.pointer("keydown", "Right")
        until(lambda: self.so_far()["duration"] > 0, "the world to go on", self.game)
        self.pointer("keyup", "Right")
        run = self.save()
        self.assertEqual(self.inputs(run)[0]["t"], 0)
        self.assertGreater(self.inputs(run)[0]["tilt"], 0)
        self.assertGreater(json.loads(run.read_text())["duration"], 0)
        self.done("verify", run)

    def test_a_press_beside_the_ball_grabs_nothing_and_one_near_it_takes_it_and_q_ends_the_program(self):
        self.open("software")
        self.drag(TARGET, START)
        run = self.save()
        self.assertEqual(self.times_of("grab", run), [])
        run.unlink()
        self.drag((START[0] + 1.7 * 0.4, START[1]), TARGET)
        self.assert_grabs(self.save(), 1)
        self.press_key("q")
        self.assertEqual(self.game.wait(timeout=PATIENCE), 0)

    def test_a_ball_that_is_taken_in_the_past_plays_on_from_there(self):
        self.open("software")
        self.drag_the_ball()
        whole_inputs = self.so_far()["inputs"]
        empty = self.patch(START)
        self.pointer("keydown", "comma")
        until(lambda: self.differs(empty, START), "the ball to be back where it began", self.game)
        self.wait_until_still("the beginning, where time stands")
        self.pointer("keyup", "comma")
        self.drag(START, (START[0] + 2, START[1]))
        run = self.save()
        self.assert_grabs(run, 2)
        common = [entry for entry in whole_inputs if entry in self.inputs(run)]
        self.assertEqual(common, self.inputs(run)[:len(common)])
        self.assertNotIn(whole_inputs[-1], self.inputs(run))  # the first release is no part of it any more
        self.done("verify", run)

    def test_at_the_goal_the_ball_is_let_go_the_card_has_a_button_that_films_and_enter_goes_on(self):
        self.open("software", self.file("goal.svg", LEVEL.format(GOAL)))
        self.press_at(START)
        self.move_to((6.5, 5))
        best = self.folder / "data/smb2d/best.json"
        until(best.exists, "the time to be kept", self.game)
        run = self.save()  # the button is still down
        self.assertIn("release", self.inputs(run)[-1])
        goal = self.times_of("goal", run)[0]
        self.assertEqual(list(json.loads(best.read_text()).values()), [goal])
        self.assertLess(self.inputs(run)[-1]["t"] - goal, 0.2)
        run.unlink()
        self.pointer("mouseup", 1)
        before = self.name()
        self.pointer("sleep", 1)  # the card is open
        # A card of one line, the hint: 540 by 160 + 30 + 48, its button 36 high, 4 above where the lines end.
        unit = HEIGHT / 720
        card = max(62 * unit, 0.36 * HEIGHT - 238 / 2 * unit)
        self.click(WIDTH / 2, card + (186 + 18) * unit)
        until(lambda: list((self.folder / "data").rglob("*.mp4")), "the film", self.game)
        self.assertEqual(self.name(), before)  # it did not go on
        for filmed in (self.folder / "data").rglob("*.json"):
            if filmed != best:
                filmed.unlink()

        def goes_on():
            self.press_key("Return")
            return self.name() != before

        until(goes_on, "the next level", self.game)
        self.assertEqual(self.so_far()["duration"], 0)

    def test_the_picker_scrolls_by_its_arrow(self):
        levels = self.folder / "levels"
        levels.mkdir()
        for i in range(17):
            (levels / f"{i:02}.svg").write_text(SMALL_LEVEL)
        (levels / "17.svg").write_text(SMALL_LEVEL.replace("<title>Small", "<title>The last"))
        self.open("software", levels)
        unit = HEIGHT / 720
        click = lambda x, y: self.click(WIDTH / 2 + x * unit, y * unit)
        for _ in range(2):  # five rows, of which three are seen
            before = self.screenshot()
            click(617, 636)
            until(lambda: self.screenshot() != before, "the next row", self.game)
        click(-596 + 304 + 100, 92 + 2 * 200 + 60)  # the second tile of the last row
        until(lambda: "The last" in self.name(), "the level", self.game)

    def test_the_title_opens_the_settings_by_its_button_and_starts_the_first_level_by_a_key(self):
        self.play()
        first = self.screenshot()
        until(lambda: self.screenshot() != first, "the title to move", self.game)
        self.click(WIDTH - 30, 25)
        self.wait_until_still("the title to stand still")
        self.click_row(self.SETTINGS, 8, 2)
        self.wait_for_preference("muted", True)
        self.press_keys("Escape")
        self.press_key("F5")  # is a key as any other: starts, and saves nothing
        run = self.so_far()
        self.assertEqual((Path(run["level"]).name, run["duration"]), ("01-sunny-hills.svg", 0))

    def heard(self):
        """What the sound device has been given so far: numbers of both sides in turn."""
        raw = self.folder / "heard.raw"
        data = raw.read_bytes() if raw.exists() else b""
        return array.array("f", data[:len(data) // 4 * 4])

    def loudest_from_now(self):
        """Of the next tenth of a second."""
        begun = len(self.heard())
        until(lambda: len(self.heard()) > begun + 9600, "the device to ask for more", self.game)
        return max(map(abs, self.heard()[begun:]))

    def test_a_landing_is_heard_and_m_mutes(self):
        self.play(self.file("floor.svg", LEVEL.format("").replace('cy="4.4"', 'cy="2"')), SDL_AUDIODRIVER="disk",
                  SDL_DISKAUDIOFILE="heard.raw")
        until(lambda: self.loudest_from_now() > 0.005, "the tune", self.game)
        self.press_key("space")
        # The tune and its limit are far below.
        until(lambda: max(map(abs, self.heard()), default=0) > 0.13, "the landing", self.game)
        self.press_key("m")
        until(lambda: self.loudest_from_now() == 0, "silence", self.game)
        self.wait_for_preference("muted", True)
        self.assertEqual(self.preferences()["volume"], 0.8)
        self.press_key("m")
        until(lambda: self.loudest_from_now() > 0.005, "the tune to come back", self.game)
        self.press_key("space")
        until(lambda: self.loudest_from_now() == 0, "silence in the pause", self.game)
        for _ in range(9):
            self.press_key("minus")
        self.wait_for_preference("volume", 0)
        self.close()

    def test_without_a_sound_device_the_game_plays_on_without_a_word(self):
        # The second as ALSA has it where there is no card, which it tells at length.
        for changes, words in [({"SDL_AUDIODRIVER": "none such"}, []),
                               ({"SDL_AUDIODRIVER": "alsa", "ALSA_CONFIG_PATH": "/dev/null"}, []),
                               ({"SDL_AUDIODRIVER": "disk"}, ["--no-sound"])]:
            self.play(self.file("floor.svg", LEVEL.format("")), *words, **changes)
            self.press_key("q")
            self.assertEqual(self.last_words(0), b"")
            self.assert_no_files("*.raw")

    def test_f6_films_what_was_played_while_the_game_goes_on(self):
        self.open("software")
        self.press_key("space")
        until(lambda: self.so_far()["duration"] > 0.2, "the world to go on", self.game)
        self.press_key("F6")
        films = lambda: [path for path in (self.folder / "data").rglob("*.mp4") if ".part." not in path.name]
        film = until(films, "the film", self.game)[0]
        duration = json.loads(film.with_suffix(".json").read_text())["duration"]
        self.assertEqual(self.frames_in(film), math.ceil(duration * 60 - 1e-9))
        film.with_suffix(".json").unlink()
        self.assertGreater(self.so_far()["duration"], duration)

    def test_a_film_that_the_end_of_the_program_cuts_short_is_named_or_gone(self):
        self.open("software")
        self.drag_the_ball()
        self.press_key("F6")
        until(lambda: list((self.folder / "data").rglob("*.part.mp4")), "the film to begin", self.game)
        self.press_key("q")
        stderr = self.last_words(0)
        for part in (self.folder / "data").rglob("*.part.mp4"):
            self.assertIn(part.name.encode(), stderr)

    def open_card(self, key="Escape"):
        """The menu, or what else stops the game, painted: until then the picture moves by itself."""
        before = self.screenshot()
        self.press_key(key)
        until(lambda: self.screenshot() != before, "the card", self.game)
        self.wait_until_still("the card to be painted")

    def test_the_menu_stops_the_game_and_its_entries_do_what_they_say(self):
        self.open("software")
        self.drag_the_ball()
        self.open_card()
        still = self.screenshot()
        self.pointer("sleep", 0.3)
        self.assertEqual(self.screenshot(), still)
        self.press_key("Escape")
        until(lambda: self.screenshot() != still, "the game to go on", self.game)
        self.assertGreater(self.so_far()["duration"], 0)
        self.open_card()
        self.press_key("Down")
        self.press_key("Return")
        self.assertEqual(self.so_far()["duration"], 0)  # from the beginning
        self.open_card()
        self.press_key("Up")
        self.press_key("Return")
        self.assertEqual(self.game.wait(timeout=PATIENCE), 0)

    def preferences(self):
        kept = self.folder / "data/smb2d/preferences.json"
        return json.loads(kept.read_text()) if kept.exists() else {}

    def wait_for_preference(self, name, value):
        until(lambda: self.preferences().get(name) == value, f"{name} to be {value}", self.game)

    def press_keys(self, *keys):
        """One after the other where nothing moves by itself, each shown before the next is pressed."""
        for key in keys:
            before = self.screenshot()
            self.press_key(key)
            until(lambda: self.screenshot() != before, f"what {key} changes", self.game)

    def test_the_page_of_settings_is_worked_by_keys_and_a_key_that_is_chosen_holds_after_a_restart(self):
        self.open("software")
        self.open_card()
        self.press_keys("Up", "Up", "Return", "Down")  # settings; its second row
        self.press_key("Left")
        self.wait_for_preference("volume", 0.7)
        self.press_keys("Down")
        for row, value in [("muted", True), ("turning", False), ("reduced_motion", True), ("high_contrast", True),
                           ("language", "english")]:
            self.press_key("Return")
            self.wait_for_preference(row, value)
            if row != "language":
                self.press_keys("Down")
        self.press_keys("Left")
        self.wait_for_preference("language", "system")
        self.press_keys("Escape", "Escape")  # back to the menu, and to the game
        self.assertEqual(self.so_far()["duration"], 0)
        self.open_card("F2")
        self.press_keys("Return", "Right", "Down", "Down", "Down", "Down")  # keys: save, in the second column
        self.press_keys("Return", "Escape", "Return")
        self.assertEqual(self.preferences().get("keys", {}), {})
        self.press_key("o")
        self.wait_for_preference("keys", {"save": ["O"], "overlay": ["F5"]})
        self.close()

        self.play(self.file("floor.svg", LEVEL.format("")))
        self.save("o")
        self.assertEqual(self.game.poll(), None)

    def on_card(self, form, rows, row, share=0.5):
        """Where a row of a card is, in pixels: (width, columns, row, gap, below) as in src/view/menu.h."""
        width, columns, high, gap, below = form
        unit, per_column = HEIGHT / 720, math.ceil(rows / columns)
        tall = 84 + per_column * (high + gap) - gap + below
        wide = (width - 68 - 20 * (columns - 1)) / columns
        x = WIDTH / 2 + (-width / 2 + 34 + row // per_column * (wide + 20) + share * wide) * unit
        y = HEIGHT / 2 + (-tall / 2 + 84 + row % per_column * (high + gap) + high / 2) * unit
        return x, y

    def click_row(self, *where, **options):
        self.click(*self.on_card(*where, **options))

    SETTINGS, KEYS = (640, 1, 50, 8, 62), (1200, 2, 34, 6, 58)

    def test_the_page_of_settings_and_the_menu_are_worked_by_the_pointer(self):
        self.open("software")
        self.open_card("F2")
        self.click_row(self.SETTINGS, 8, 1, share=(572 - 28 - 90) / 572)  # the middle of the bar
        self.wait_for_preference("volume", 0.5)
        for row, name, value in [(2, "muted", True), (3, "turning", False), (4, "reduced_motion", True),
                                 (5, "high_contrast", True), (6, "language", "english")]:
            self.click_row(self.SETTINGS, 8, row)
            self.wait_for_preference(name, value)
        before = self.screenshot()
        self.click_row(self.SETTINGS, 8, 0)
        until(lambda: self.screenshot() != before, "the page of keys", self.game)
        self.click_row(self.KEYS, 27, 18)  # save
        self.press_key("F9")
        self.wait_for_preference("keys", {"save": ["F9"]})
        self.click_row(self.KEYS, 27, 25)  # all as they came
        self.wait_for_preference("keys", {})
        self.press_keys("Escape", "Escape")
        self.open_card()
        row = lambda i: HEIGHT / 2 + (i - 2.5) * 68 * HEIGHT / 720 + 25 * HEIGHT / 720
        self.click(WIDTH * 3 / 8, row(3))
        self.wait_for_preference("muted", False)
        self.click(WIDTH / 2, row(5))
        self.assertEqual(self.game.wait(timeout=PATIENCE), 0)

    def test_a_key_that_does_not_exist_is_told_in_one_line(self):
        self.file("data/smb2d/preferences.json", '{"keys": {"pause": ["Spcae"]}}')
        self.open("software")
        self.press_key("q")
        self.assert_one_line(self.last_words(0), 'preferences.json: keys: pause: there is no key "Spcae"')

    def test_the_language_is_that_of_the_settings_else_the_systems(self):
        level = self.file("floor.svg", LEVEL.format(""))
        menus = {}
        for name, locale, chosen in [("english", "C", None), ("by system", "de_DE.UTF-8", None),
                                     ("by choice", "C", "german"), ("against system", "de_DE.UTF-8", "english")]:
            self.file("data/smb2d/preferences.json", json.dumps({"language": chosen} if chosen else {}))
            self.play(level, LC_ALL=locale)
            self.open_card("F2")
            menus[name] = self.screenshot()
            self.close()
        middle = lambda name: [menus[name][y * WIDTH + x] for y in range(HEIGHT // 7, HEIGHT * 8 // 9)
                               for x in range(WIDTH // 4, WIDTH // 2)]
        self.assertNotEqual(middle("english"), middle("by system"))
        self.assertEqual(middle("by system"), middle("by choice"))
        self.assertEqual(middle("english"), middle("against system"))

    def test_a_broken_level_of_a_folder_is_told_and_the_rest_plays(self):
        self.file("levels/a.svg", RED_FLOOR)
        self.file("levels/b.svg", RED_FLOOR.replace('r="0.5"', 'r="-1"'))
        self.file("levels/c.svg", RED_FLOOR.replace("#f00", "#00f"))
        self.play(self.folder / "levels")
        self.press_key("Right")
        self.press_key("Return")
        self.assertIn(b"b.svg:3: ball: r must be greater than 0, got -1", self.game.stderr.readline())
        self.press_key("Right")
        self.press_key("Return")
        self.until_colour(0x0000ff)
        self.close()

    def name(self):
        return self.display.property(int(self.window), "_NET_WM_NAME").decode()

    def drop(self, path):
        self.display.drop(path, int(self.window))

    def test_levels_and_folders_dropped_on_the_window_are_opened_else_told_and_the_game_stays(self):
        self.file("levels/a.svg", SMALL_LEVEL.replace("Small", "One of a folder"))
        self.file("levels/b.svg", SMALL_LEVEL.replace("Small", "Its other"))
        one = self.file("one level.svg", SMALL_LEVEL.replace("Small", "Dropped"))
        broken = self.file("broken.svg", SMALL_LEVEL.replace('r="0.5"', 'r="-1"'))
        self.open("software")
        before = self.name()
        self.drop(broken)
        self.assertIn(b"broken.svg:3: ball: r must be greater than 0, got -1", self.game.stderr.readline())
        (self.folder / "empty").mkdir()
        self.drop(self.folder / "empty")
        self.assertIn(b"there is no level in this folder", self.game.stderr.readline())
        self.assertEqual(self.name(), before)
        self.press_key("Next")  # from the level that was there before
        until(lambda: self.name() != before, "the next level", self.game)
        self.press_key("Prior")
        until(lambda: self.name() == before, "the level before", self.game)
        self.drop(one)
        until(lambda: self.name().endswith("Dropped"), "the level", self.game)
        self.drop(self.folder / "levels")
        until(lambda: self.name().endswith("One of a folder"), "the folder's first level", self.game)
        self.press_key("Right")
        self.press_key("Return")
        until(lambda: self.name().endswith("Its other"), "the level that is picked", self.game)
        self.close()

    def test_spoilt_preferences_are_told_at_once_and_set_aside_when_a_change_is_kept(self):
        spoilt = self.file("data/smb2d/preferences.json", '{"volume": 0.')
        self.open("software")
        self.assertIn(b"preferences.json: cannot be read as JSON", self.game.stderr.readline())
        self.drag_the_ball()  # play goes on
        self.assertEqual(spoilt.read_text(), '{"volume": 0.')
        self.press_key("m")
        aside = spoilt.with_name("preferences.json.spoilt")
        self.assertIn(aside.name.encode(), self.game.stderr.readline())
        self.assertEqual(aside.read_text(), '{"volume": 0.')
        self.wait_for_preference("muted", True)
        self.close()

    def test_closed_while_a_renderer_is_loaded_the_program_ends_as_ever(self):
        for key, status in [("q", 0), (None, 130)]:
            self.open("auto")
            if key:
                self.press_key(key)
            else:
                self.game.send_signal(signal.SIGTERM)
            self.assertEqual(self.last_words(status), b"" if key else b"smb2d: interrupted\n")

    def test_the_first_pictures_are_followed_by_a_renderers(self):
        self.open("auto")
        self.assertTrue(len(set(self.screenshot())) > 50)
        loaded = lambda: any(name in Path(f"/proc/{self.game.pid}/maps").read_text() for name in ("OSMesa", "libGL"))
        until(loaded, "a renderer", self.game)
        self.save()
        self.close()

    def test_what_is_rendered_is_not_changed_by_settings(self):
        def frame(name):
            self.done("render", self.small_level, "-o", name, "-s", "64x36", "--to", "0.1", "--fps", "10")
            return (self.folder / name).read_bytes()

        usual = frame("usual.png")
        self.file("data/smb2d/preferences.json", json.dumps({"high_contrast": True, "reduced_motion": True,
                                                             "turning": False, "language": "german"}))
        self.assertEqual(frame("chosen.png"), usual)


if __name__ == "__main__":
    main()
