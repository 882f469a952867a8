#!/usr/bin/python3
"""What large and malicious drawings cost: user CPU time, wall time and memory of `smb2d check` and of a first picture.

usage: tools/drawings_bench.py [SMB2D [NAME...]]    NAME: only the inputs whose names begin with one of these
"""

import gzip
import math
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TOP = Path(__file__).resolve().parent.parent
HEAD = '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 160 90">\n'
BALL = '<circle class="ball" cx="3" cy="2" r="0.5"/>\n'
LARGEST = 64_000_000  # bytes of a file
TIMEOUT = 60  # s


def level(body, ball=BALL):
    return HEAD + ball + body + "</svg>\n"


def filled(unit, before="", after=""):
    """A drawing of nearly 64 MB that repeats `unit`."""
    room = LARGEST - len(level(before + after)) - 16
    return level(before + unit * (room // len(unit)) + after)


def segments(count, elements):
    """So many lines, a wave from left to right, in so many paths."""
    each = count // elements
    step = 158 / count
    paths = []
    for i in range(elements):
        points = (f"{1 + step * k:.5f} {60 + 5 * math.sin(step * k):.5f}" for k in range(i * each, (i + 1) * each + 1))
        paths.append('<path class="terrain" fill="none" d="M' + "L".join(points) + '"/>\n')
    return level("".join(paths))


def bricks(count, paint=""):
    side = math.ceil(math.sqrt(count))
    return level("".join(
        f'<rect class="terrain"{paint} x="{1 + 150 * (i % side) / side:.4f}" y="{5 + 80 * (i // side) / side:.4f}"'
        f' width="{60 / side:.4f}" height="{32 / side:.4f}"/>\n' for i in range(count)))


def rings(count, paint=""):
    return level("".join(f'<circle class="terrain"{paint} cx="80" cy="45" r="{40 * (i + 1) / count:.5f}"/>\n'
                         for i in range(count)), '<circle class="ball" cx="3" cy="2" r="0.5"/>\n')


def arcs(count):
    """Arcs between the same two points, each with another bulge."""
    radii = (f"{60 + 400 * i / count:.6f}" for i in range(count))
    return level("".join(f'<path class="terrain" d="M20 45A{r} {r} 0 0 1 140 45"/>\n' for r in radii))


def curves(count):
    """Curves of all kinds within 100 m, handles on their ends and nearly straight ones among them: decorations, so that
    their tracing is what is measured."""
    import random
    place = random.Random(1)
    paths = []
    for i in range(count):
        at = [place.uniform(1, 99) for _ in range(8)]
        if i % 4 == 1:
            at[4:6] = at[6:8]
        if i % 4 == 2:
            for k in (0, 1):
                at[2 + k] = at[k] + (at[6 + k] - at[k]) / 3 + place.uniform(-1, 1) * 1e-3
                at[4 + k] = at[k] + (at[6 + k] - at[k]) * 2 / 3 + place.uniform(-1, 1) * 1e-3
        if i % 4 == 3:
            at[2:4] = [at[6] + place.uniform(-1, 1) * 1e-2, at[7]]
        paths.append('<path fill="none" d="M{} {}C{} {} {} {} {} {}"/>\n'.format(*at))
    return level("".join(paths))


def copies():
    """A million copies from ten lines."""
    text = '<path id="c0" class="terrain" d="M0 5H9"/>\n'
    for i in range(1, 7):
        text += f'<g id="c{i}">' + f'<use href="#c{i - 1}"/>' * 10 + "</g>\n"
    return level(text)


def chain():
    """A chain of uses, each of the one before."""
    text = '<path id="c0" class="terrain" d="M0 5H9"/>\n'
    return level(text + "".join(f'<use id="c{i}" href="#c{i - 1}"/>\n' for i in range(1, 90_000)))


INPUTS = {
    # name: (subcommand, text, status, seconds, MB): what docs/levels.md and the limits allow
    "segments-one-path": ("check", lambda: segments(100_000, 1), 0, 1, 200),
    "segments-1000-paths": ("check", lambda: segments(100_000, 1000), 0, 1, 200),
    "segments-50000-paths": ("check", lambda: segments(100_000, 50_000), 0, 1, 200),
    "curves-10000": ("check", lambda: curves(10_000), 0, 0.5, None),
    "bricks-40000": ("render", lambda: bricks(40_000), 0, 1, None),
    "bricks-40000-check": ("check", lambda: bricks(40_000), 0, None, None),
    "bricks-40000-painted": ("render", lambda: bricks(40_000, ' fill="#a52"'), 0, 1, None),
    "bricks-40000-icy": ("render", lambda: bricks(40_000).replace('"terrain"', '"terrain" data-friction="0.1"', 1), 0,
                         None, None),
    "arcs-20000": ("check", lambda: arcs(20_000), 0, 1, 200),
    "rings-40000": ("render", lambda: rings(40_000), 0, 1, None),
    "rings-40000-check": ("check", lambda: rings(40_000), 0, None, None),
    "rings-40000-painted": ("render", lambda: rings(40_000, ' fill="#a52"'), 0, 1, None),
    "large-path": ("check", lambda: filled(" 1 5 2 6", '<path class="terrain" d="M0 5', '"/>'), 3, 10, None),
    "large-comment": ("check", lambda: filled("x", "<!--", "-->"), 0, 10, None),
    "large-text": ("check", lambda: filled("x", "<desc>", "</desc>"), 0, 10, None),
    "large-attribute": ("check", lambda: filled("x ", '<path class="', '"/>'), 0, 10, None),
    "large-style": ("check", lambda: filled("a:b;", '<path class="terrain" d="M0 5H9" style="', '"/>'), 3, 10, None),
    "large-transform": ("check", lambda: filled("scale(1)", '<path class="terrain" d="M0 5H9" transform="', '"/>'), 0, 10,
                        None),
    "large-points": ("check", lambda: filled("1 5 ", '<polyline class="terrain" points="', '"/>'), 3, 10, None),
    "large-depth": ("check", lambda: level("<g>" * 99_000 + "</g>" * 99_000), 0, 10, None),
    "large-elements": ("check", lambda: filled('<path class="terrain" d="M0 5H9" id="' + "x" * 600 + '"/>\n'), 0, 10, None),
    "large-attributes": ("check", lambda: filled('<g a="1" b="2" c="3" d="4" e="5"/>'), 3, 10, None),
    "large-namespaces": ("check", lambda: level("".join(f'<g xmlns:n{i}="urn:{i}">' for i in range(90_000)) + "</g>" * 90_000),
                         0, 10, None),
    "large-classes": ("check", lambda: level("<style>" + "".join(f".c{i}{{fill:red}}" for i in range(50_000)) + "</style>"
                                             + '<path class="' + " ".join(f"c{i}" for i in range(50_000)) + '" d="M0 5H9"/>'),
                      0, 10, None),
    "classes-many": ("check", lambda: level("<style>" + "".join(f".c{i}{{fill:red}}" for i in range(50_000)) + "</style>"
                                            + ('<path class="terrain ' + " ".join(f"c{i}" for i in range(100))
                                               + '" d="M0 5H9"/>\n') * 90_000), 0, 10, None),
    "use-ring": ("check", lambda: level('<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>'), 3, 2, 500),
    "use-million": ("check", copies, 3, 2, 500),
    "use-chain": ("check", chain, None, 2, 500),
    "use-long-path": ("check", lambda: level('<path id="p" class="terrain" d="M0 5' + "l1 .1l-1-.1" * 90_000 + '"/>\n'
                                             + '<use href="#p"/>' * 1000), 3, 2, 500),
    "use-lineage": ("check", lambda: level('<g id="p">' + "<g>" * 40_000 + '<path class="terrain" d="M0 5H9"/>'
                                           + "</g>" * 40_000 + '</g>\n<use href="#p"/>'), 0, 2, 500),
    "sheet-10-MB": ("check", lambda: level("<style>" + ".a{fill:red}" * 850_000 + "</style>"), 3, 2, 500),
    "sheet-1-MB": ("check", lambda: level("<style>" + ".a{fill:red}" * 80_000 + "</style>"), 0, 2, 500),
    "sheet-open": ("check", lambda: level("<style>" + "a{" * 490_000 + "</style>"), 0, 2, 500),
    "sheet-comma": ("check", lambda: level("<style>" + "a," * 490_000 + "b{fill:red;stroke:red;opacity:1}</style>"), 0, 2, 500),
    "sheet-quotes": ("check", lambda: level("<style>" + "'{" * 490_000 + "</style>"), 0, 2, 500),
    "styles-1-MB": ("check", lambda: level(('<path class="terrain" d="M0 5H9" style="' + "fill:red;" * 110_000 + '"/>\n') * 60),
                    0, 10, None),
    "gradients-shared": ("check", lambda: level('<linearGradient id="g">' + '<stop offset=".5" stop-color="red"/>' * 80_000
                                                + "</linearGradient>" + "".join(
                                                    f'<linearGradient id="h{i}" href="#g"/>'
                                                    f'<rect width="1" height="1" fill="url(#h{i})"/>\n' for i in range(5000))),
                         0, 2, 500),
    "goals-stars": ("check", lambda: level("".join(
        '<polygon class="goal" points="' + " ".join(
            f"{80 + r * math.cos(a):.4f},{45 + r * math.sin(a):.4f}" for i in range(480)
            for r, a in [(20 + 6 * (i % 2), math.tau * i / 480)]) + '"/>\n' for _ in range(300))), 3, 2, 500),
    "flat": ("check", lambda: level('<path class="terrain" transform="scale(0)" d="M0 5H9"/>'), 3, 2, 500),
    "nan": ("check", lambda: level('<path class="terrain" d="M0 5LNaN 6"/>'), 3, 2, 500),
    "gzip-bomb": ("check", lambda: gzip.compress(HEAD.encode() + b" " * 1_000_000_000, 1),
                  3, 2, 500),
}


def measured(binary, subcommand, file, folder):
    arguments = [binary, subcommand, file]
    if subcommand == "render":
        arguments += ["-o", f"{folder}/%d.png", "--to", "0.01", "--jobs", "2", "-q", "--overwrite"]
    before = time.perf_counter()
    child = subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace",
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (TIMEOUT, TIMEOUT)))
    out = child.stdout.read()
    err = child.stderr.read()
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    wall = time.perf_counter() - before
    return child.returncode, usage.ru_utime + usage.ru_stime, wall, usage.ru_maxrss / 1000, (out + err).strip()


def main():
    binary = sys.argv[1] if len(sys.argv) > 1 else str(TOP / "build" / "release" / "smb2d")
    names = sys.argv[2:]
    print(f"{'drawing':24}{'MB':>7}{'status':>7}{'cpu s':>8}{'wall s':>8}{'RSS MB':>8}  first line")
    missed = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, (subcommand, make, status, seconds, megabytes) in INPUTS.items():
            if names and not any(name.startswith(n) for n in names):
                continue
            data = make()
            file = Path(folder) / (name + ".svg")
            file.write_bytes(data if isinstance(data, bytes) else data.encode())
            size = file.stat().st_size / 1e6
            got, cpu, wall, memory, text = measured(binary, subcommand, str(file), folder)
            file.unlink()
            wrong = ((status is not None and got != status) or (seconds is not None and cpu > seconds)
                     or (megabytes is not None and memory > megabytes))
            missed += wrong
            first = text.replace(folder + "/", "").split("\n")[0][:90]
            lines = text.count("\n") + 1
            print(f"{name:24}{size:7.1f}{got:7}{cpu:8.2f}{wall:8.2f}{memory:8.0f}  {'MISSED ' if wrong else ''}"
                  f"{first} ({lines} lines)", flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
