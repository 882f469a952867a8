#!/usr/bin/python3
"""Frames a second of `smb2d render` against the same scene drawn and saved with pygame, and the memory that smb2d takes.

usage: tools/pictures_bench.py [SMB2D [FOLDER]]    needs python3-pygame, Xvfb, and /dev/shm to write to;
the last picture of each is put into FOLDER
"""

import csv
import io
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

os.environ.update(SDL_VIDEODRIVER="dummy", SDL_AUDIODRIVER="dummy", PYGAME_HIDE_SUPPORT_PROMPT="1")
import pygame  # noqa: E402  after its settings

TOP = Path(__file__).resolve().parent.parent
SECONDS = 3
RATE = 60
SIZE = (1280, 720)
HILLS = [(x / 4, 6.5 + math.sin(x / 6) - x / 80) for x in range(65)]
OUTLINES = [HILLS + [(16, 9), (0, 9)], [(9, 3.6), (13, 3.9), (13, 4.3), (9, 4.0)]]


def rendered(binary, level, folder):
    """Frames a second of our program, start and simulation included, with two jobs."""
    before = time.perf_counter()
    command = [binary, "render", level, "-o", f"{folder}/%05d.png", "--to", str(SECONDS), "--jobs", "2", "-q"]
    subprocess.run(command, check=True)
    return SECONDS * RATE / (time.perf_counter() - before)


def written_level(folder):
    """Hills, a platform and three balls, 16 m x 9 m, as SVG."""
    outlines = (" ".join(f"{x},{y}" for x, y in outline) for outline in OUTLINES)
    shapes = "".join(f'<polygon class="terrain" points="{points}"/>' for points in outlines)
    balls = "".join(f'<circle class="ball" cx="{x}" cy="3" r="0.5"/>' for x in (2, 6, 11))
    level = f"{folder}/hills.svg"
    Path(level).write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 9">{shapes}{balls}</svg>')
    return level


def balls_of(binary, level):
    trace = subprocess.run([binary, "simulate", level, "--to", str(SECONDS)], check=True, capture_output=True, text=True)
    frames = {}
    for row in csv.DictReader(io.StringIO(trace.stdout)):
        frames.setdefault(row["t"], []).append((float(row["x"]), float(row["y"]), float(row["angle"])))
    return list(frames.values())[: SECONDS * RATE]


def draw(surface, balls):
    """Sky, ground with an edge, and each ball as a striped disc with a face: what a pygame program would draw."""
    scale = SIZE[0] / 16
    for y in range(0, SIZE[1], 8):
        pygame.draw.rect(surface, (120 + y // 8, 170 + y // 16, 230), (0, y, SIZE[0], 8))
    for outline in OUTLINES:
        points = [(x * scale, y * scale) for x, y in outline]
        pygame.draw.polygon(surface, (120, 160, 80), points)
        pygame.draw.aalines(surface, (240, 250, 220), True, points)
    for x, y, angle in balls:
        centre = (x * scale, SIZE[1] - y * scale)
        pygame.draw.circle(surface, (220, 90, 60), centre, 0.5 * scale)
        pygame.draw.circle(surface, (250, 240, 220), centre, 0.35 * scale)
        for turn in (0, 1, 2):
            spoke = angle + turn * math.pi / 3
            way = (0.5 * scale * math.cos(spoke), -0.5 * scale * math.sin(spoke))
            pygame.draw.line(surface, (90, 40, 30), (centre[0] - way[0], centre[1] - way[1]),
                             (centre[0] + way[0], centre[1] + way[1]), 2)


def drawn_with_pygame(binary, level, folder):
    """Frames a second of pygame, the simulation left out."""
    surface = pygame.Surface(SIZE)
    frames = balls_of(binary, level)
    before = time.perf_counter()
    for i, balls in enumerate(frames):
        draw(surface, balls)
        pygame.image.save(surface, f"{folder}/{i:05}.png")
    return len(frames) / (time.perf_counter() - before)


def peak_memory(command, seconds=None, **environment):
    """MB resident at most, of a program that ends by itself or is ended after `seconds`."""
    process = subprocess.Popen(command, env=dict(os.environ, **environment), stderr=subprocess.DEVNULL)
    if seconds is not None:
        time.sleep(seconds)
        process.terminate()
    _, _, usage = os.wait4(process.pid, 0)
    process.returncode = 0
    return usage.ru_maxrss / 1024


def window_memory(binary, level):
    display = f":{os.getpid() % 1000 + 100}"
    server = subprocess.Popen(["Xvfb", display, "-screen", "0", "1400x900x24"], stderr=subprocess.DEVNULL)
    try:
        time.sleep(1)
        return peak_memory([binary, "play", level], 6, DISPLAY=display, SDL_VIDEODRIVER="x11", SDL_AUDIODRIVER="dummy")
    finally:
        server.terminate()
        server.wait()


def main():
    binary = sys.argv[1] if len(sys.argv) > 1 else str(TOP / "build/release/smb2d")
    with tempfile.TemporaryDirectory(dir="/dev/shm") as folder:
        level = written_level(folder)
        ours, theirs = [], []
        for turn in range(2):  # in turn, so that both meet the same machine
            for measured, results in ((rendered, ours), (drawn_with_pygame, theirs)):
                frames = f"{folder}/{measured.__name__}{turn}"
                Path(frames).mkdir()
                results.append(measured(binary, level, frames))
                if len(sys.argv) > 2:
                    shutil.copy(sorted(Path(frames).iterdir())[-1], f"{sys.argv[2]}/{measured.__name__}.png")
                shutil.rmtree(frames)
        print(f"smb2d render --jobs 2: {max(ours):7.1f} frames/s of {SIZE[0]}x{SIZE[1]}")
        print(f"pygame {pygame.version.ver}:          {max(theirs):7.1f} frames/s, ratio {max(ours) / max(theirs):.1f}")
        command = [binary, "render", level, "-o", f"{folder}/%05d.png", "--to", "1", "-q", "--overwrite", "--jobs"]
        for jobs in ("1", "2"):
            print(f"render --jobs {jobs}: {peak_memory(command + [jobs]):.0f} MB resident at most")
        print(f"play under Xvfb: {window_memory(binary, level):.0f} MB resident at most")


main()
