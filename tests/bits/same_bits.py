#!/usr/bin/env python3
"""T20: the same runs come to the same bits, whoever compiled the program and whatever was changed in it.

    same_bits.py golden BITS           compares what the program BITS prints with golden.txt
    same_bits.py write BITS            writes golden.txt anew: tools/golden
    same_bits.py compiler BITS FLAGS [LEVEL]
                                       builds BITS with another compiler, beside it, and compares what that prints; with
                                       the library LEVEL in place of compiling the floor that reads drawings, too, where
                                       both have the same standard library
    same_bits.py others BITS           does so with all that are not tested one by one, if SMB2D_ALL_COMPILERS=1
"""

import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[1]
GOLDEN = HERE / "golden.txt"

# The five that differ most are tests of their own: CMakeLists.txt names them.
OTHERS = ["g++ -O1", "g++ -O2", "g++ -O3", "g++ -Os", "g++ -O2 -D_GLIBCXX_ASSERTIONS", "clang++ -O0", "clang++ -O1",
          "clang++ -O3 -march=native", "clang++ -O0 -stdlib=libc++", "clang++ -O3 -march=native -stdlib=libc++"]

SEEDED_LEVELS, FEW_SEEDED_LEVELS = 40, 4
SKIPPED = 77  # the status that ctest takes for a test that was not asked for


def seeded_level(seed):
    """Hills of lines, arcs and curves, steep and flat, and up to three balls. Nothing but random() is the same in every
    version of Python."""
    dice = random.Random(seed)
    between = lambda low, high: round(low + (high - low) * dice.random(), 3)
    surface = f'data-restitution="{between(0, 0.9)}" data-friction="{between(0, 1)}"'
    x, path = -1.0, f"M -1 {between(5, 8)}"
    while x < 17:
        width, y, kind = between(0.6, 3), between(5, 8), int(3 * dice.random())
        x = round(x + width, 3)
        if kind == 0:
            path += f" L {x} {y}"
        elif kind == 1:
            path += f" A {between(2, 6)} {between(2, 6)} 0 0 {int(2 * dice.random())} {x} {y}"
        else:
            path += f" Q {round(x - width / 2, 3)} {between(4.5, 8.5)} {x} {y}"
    balls = [f'<circle class="ball" cx="{between(2, 4) + 4 * i}" cy="{between(1, 3)}" r="{between(0.2, 0.5)}" '
             f'data-velocity="{between(-3, 3)} {between(-3, 3)}"/>' for i in range(1 + int(3 * dice.random()))]
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 9"><path class="terrain" {surface} d="{path}"/>'
            f'<path class="terrain" d="M -1 0 V 9 M 17 0 V 9"/>{"".join(balls)}</svg>\n')


def words_of_run(file):
    """A recorded run as `bits` reads it."""
    run = json.loads(file.read_text())
    lines = [f"run {file.name} {os.path.relpath(file.parent / run['level'], TOP)} {run['duration']} {len(run['inputs'])}"]
    for entry in run["inputs"]:
        time = repr(entry["t"])
        if "grab" in entry:
            grab = entry["grab"]
            lines.append(f"{time} grab {grab['ball']} {grab['x']!r} {grab['y']!r}")
        elif "move" in entry:
            lines.append(f"{time} move {entry['move']['x']!r} {entry['move']['y']!r}")
        elif "release" in entry:
            lines.append(f"{time} release")
        else:
            lines.append(f"{time} tilt {entry['tilt']!r}")
    return "\n".join(lines) + "\n"


def experiments():
    return sorted((TOP / "assets/lab").glob("*.svg"))


def seeded_name(seed):
    return f"seed-{seed:03}.svg"


def printed_by(program, everything=True):
    """The lines that a program `bits` prints of all experiments, shipped levels and runs, and of the seeded levels; or
    of the experiments and a few seeded levels."""
    levels = experiments()
    shipped = sorted((TOP / "assets/levels").glob("*.svg"))
    runs = sorted((TOP / "assets/runs").glob("*.json"))
    if not levels or not shipped or not runs:
        sys.exit("levels or runs are missing in assets")
    if everything:
        levels += shipped
    else:
        runs = []
    with tempfile.TemporaryDirectory(prefix="smb2d-bits-") as folder:
        for seed in range(SEEDED_LEVELS if everything else FEW_SEEDED_LEVELS):
            levels.append(Path(folder) / seeded_name(seed))
            levels[-1].write_text(seeded_level(seed))
        result = subprocess.run([program, *levels], input="".join(map(words_of_run, runs)), stdout=subprocess.PIPE,
                                cwd=TOP, text=True)
    if result.returncode != 0:
        sys.exit(f"{program} ended with {result.returncode}")
    return result.stdout.splitlines()


def name_of(line):
    return line.rsplit(" ", 2)[0]


def differences(expected, lines, name):
    """How many lines differ or are missing; the first few are shown."""
    hashes = {name_of(line): line for line in lines}
    wanted = {name_of(line): line for line in expected}
    wrong = [key for key in {**wanted, **hashes} if wanted.get(key) != hashes.get(key)]
    for key in wrong[:10]:
        print(f"{name}: {hashes.get(key, f'{key} is missing')}\n    expected: {wanted.get(key, 'nothing')}")
    print(f"{name}: {len(wrong)} of {len(wanted)} differ")
    return len(wrong)


def build(folder, flags, level=""):
    """`bits` built in a folder of its own; sys.exit with what was said when that fails."""
    compiler, options = flags.split(" ", 1)
    folder.mkdir(parents=True, exist_ok=True)
    quick = {**os.environ, "GLIBC_TUNABLES": os.environ.get("COMPILERS_MALLOC", "")}
    with open(folder / "build.log", "w+") as log:
        for command in [["cmake", "-S", HERE, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None",
                         f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={options}", f"-DSMB2D_LEVEL={level}"],
                        ["cmake", "--build", folder]]:
            if subprocess.run(command, stdout=log, stderr=subprocess.STDOUT, env=quick).returncode != 0:
                log.seek(0)
                sys.exit(f"{flags}: could not build\n{log.read()}")
    return folder / "bits"


def golden_lines():
    if not GOLDEN.exists():
        sys.exit("there is no golden.txt: tools/golden writes it")
    return GOLDEN.read_text().splitlines()


def compare_with_golden(program):
    wrong = differences(golden_lines(), printed_by(program), "golden.txt")
    if wrong:
        print("Bits have changed. If that is meant, run tools/golden, and say in the commit what changes them and why.")
    return 1 if wrong else 0


def compare_compiler(program, flags, level=""):
    """Without optimisation a program takes fifty times as long: it moves fewer levels."""
    everything = "-O0" not in flags or all_wanted()
    expected = golden_lines()
    if not everything:
        few = {path.name for path in experiments()} | {seeded_name(seed) for seed in range(FEW_SEEDED_LEVELS)}
        expected = [line for line in expected if line.split(" ", 1)[0] in few]
    if "libc++" in flags:
        level = ""
    lines = printed_by(build(program.parent / "same_bits" / flags.replace(" ", ""), flags, level), everything)
    return 1 if differences(expected, lines, flags) else 0


def all_wanted():
    return os.environ.get("SMB2D_ALL_COMPILERS", "0") not in ("", "0")


def compare_others(program):
    if not all_wanted():
        print("not asked for: SMB2D_ALL_COMPILERS is not set")
        return SKIPPED
    return max(compare_compiler(program, flags) for flags in OTHERS)


def write_golden(program):
    lines = printed_by(program)
    if GOLDEN.exists():
        differences(GOLDEN.read_text().splitlines(), lines, "golden.txt until now")
    GOLDEN.write_text("\n".join(lines) + "\n")
    return 0


def main():
    actions = {"golden": compare_with_golden, "write": write_golden, "compiler": compare_compiler, "others": compare_others}
    if len(sys.argv) not in ([4, 5] if sys.argv[1:2] == ["compiler"] else [3]) or sys.argv[1] not in actions:
        sys.exit(__doc__)
    sys.exit(actions[sys.argv[1]](Path(sys.argv[2]).resolve(), *sys.argv[3:]))


if __name__ == "__main__":
    main()
