"""The program under test, started as its users start it: without a display, in a folder that is thrown away."""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

if len(sys.argv) < 2:
    sys.exit("usage: test_X.py PATH-OF-SMB2D [TEST...]")
BINARY = os.path.abspath(sys.argv.pop(1))
ASSETS = Path(__file__).resolve().parents[2] / "assets"
SANITIZED = "SMB2D_SANITIZED" in os.environ  # then tests run fewer cases where cases are many
PATIENCE = 120  # s, for anything that is waited for; sanitizers and busy machines are slow

# A level with everything in it and nothing to wait for.
SMALL_LEVEL = """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 4.5"><title>Small</title>
<path id="floor" class="terrain" d="M -1 4 H 20"/>
<circle class="ball" cx="2" cy="3.5" r="0.5" data-velocity="1 0" data-spin="-2"/></svg>
"""


def environment(**changes):
    """The caller's, with a display that does not exist, a sound device that nobody hears and nobody's own data folder;
    None removes a name."""
    result = dict(os.environ, DISPLAY=":9999", NO_COLOR="1", SDL_AUDIODRIVER="dummy")
    result.pop("WAYLAND_DISPLAY", None)
    if SANITIZED:
        # What Mesa keeps until the end is known by its library. To look up names as well takes a quarter of the time of a
        # picture: reports have addresses here, which asan_symbolize turns into lines.
        result["ASAN_OPTIONS"] = result.get("ASAN_OPTIONS", "") + ":symbolize=0"
    for name, value in changes.items():
        result.pop(name, None)
        if value is not None:
            result[name] = value
    return result


def files_no_longer_than(size):
    """For a child: a write beyond `size` bytes fails, as it does on a full disk."""

    def limit():
        import resource

        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

    return limit


def until(condition, what, process=None):
    """What `condition` returns once it is true; a failure that says `what` when that takes too long."""
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline:
        result = condition()
        if result:
            return result
        if process is not None and process.poll() is not None:
            raise AssertionError(f"ended with {process.returncode} before {what}: {process.stderr.read().decode()}")
        time.sleep(0.02)
    raise AssertionError(f"waited {PATIENCE} s in vain: {what}")


class ProgramTest(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="smb2d-test-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.small_level = self.file("small.svg", SMALL_LEVEL)

    def file(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def environment(self, **changes):
        return environment(XDG_DATA_HOME=str(self.folder / "data"), **changes)

    def smb2d(self, *words, stdout=subprocess.PIPE, changes=None, **options):
        return subprocess.run([BINARY, *map(str, words)], stdout=stdout, stderr=subprocess.PIPE,
                              stdin=subprocess.DEVNULL, cwd=self.folder, env=self.environment(**(changes or {})),
                              timeout=PATIENCE, **options)

    def start(self, *words, changes=None, **options):
        process = subprocess.Popen([BINARY, *map(str, words)], stdin=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                   cwd=self.folder, env=self.environment(**(changes or {})), **options)

        def end():
            if process.poll() is None:
                process.kill()
            process.communicate()

        self.addCleanup(end)
        return process

    def done(self, *words, status=0, **options):
        """The output of a command that must succeed, or end with the status, and say nothing but data."""
        result = self.smb2d(*words, **options)
        self.assertEqual((result.returncode, result.stderr), (status, b""), (words, result.stdout))
        return result.stdout

    def assert_fails(self, status, *words, says="", **options):
        """Fails with the status and exactly one line on stderr, which holds `says`."""
        result = self.smb2d(*words, **options)
        self.assert_one_line(result.stderr, says)
        self.assertEqual(result.returncode, status, (words, result.stderr))
        return result

    def assert_ends(self, process, status, says=""):
        """With the status and one line on stderr, which is returned."""
        _, stderr = process.communicate(timeout=PATIENCE)
        self.assert_one_line(stderr, says)
        self.assertEqual(process.returncode, status, stderr)
        return stderr.decode()

    def assert_interrupted(self, process, says=""):
        process.send_signal(signal.SIGINT)
        self.assert_ends(process, 130, says)

    def probed(self, film, entries, *options):
        """What ffprobe says of a film's streams, word by word in its own order."""
        return subprocess.run(["ffprobe", "-v", "error", *options, "-show_entries", f"stream={entries}", "-of",
                               "default=nokey=1:noprint_wrappers=1", self.folder / film], stdout=subprocess.PIPE,
                              check=True).stdout.decode().split()

    def frames_in(self, film):
        """Counted by decoding them."""
        return int(self.probed(film, "nb_read_frames", "-count_frames", "-select_streams", "v")[0])

    def assert_one_line(self, stderr, says=""):
        text = stderr.decode()
        self.assertEqual(text.count("\n"), 1, text)
        self.assertTrue(text.endswith("\n") and text.strip(), text)
        self.assertIn(str(says), text)

    def assert_no_files(self, pattern="*"):
        self.assertEqual([path.name for path in self.folder.glob(pattern) if path != self.small_level], [])


def main():
    unittest.main(verbosity=1)
