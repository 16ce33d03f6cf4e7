#!/usr/bin/env python3
"""Seconds from an interrupt of a command to its end, for every kind of job and several mesh sizes.

cancel_times.py MYOLOOP [--kinds simulate,mesh,...] [--after 1,4,12]

Prints one row per kind and size, with one column per moment of the interrupt [s after the start]. "-": the command had
ended by then. A star marks what took longer than a second.
"""
import argparse
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

EXAMPLES = pathlib.Path(__file__).resolve().parent.parent / "assets" / "examples"
KINDS = ["simulate", "gradcheck", "calibrate", "diagnose", "optimize", "mesh"]
DOFS = [2e3, 20e3, 100e3, 500e3]
LIMIT_S = 120.0  # a command that has not ended by then is killed


def command(kind, dofs, out):
    """Arguments of a job on a body of about `dofs` degrees of freedom."""
    example = "soft_arm" if kind == "optimize" else "silicone_beam"
    volume_m3 = 0.120 * 0.026**2 if kind == "optimize" else 0.120 * 0.030 * 0.020
    edge_m = (3.0 * volume_m3 / dofs) ** (1.0 / 3.0)
    if kind == "mesh":
        # A tetrahedral mesh of quadratic elements has about as many nodes as one of bricks of 0.8 times the edge.
        body = EXAMPLES / "tendon_tentacle" / "body.stl"
        size = ["--unit", "mm", "--element", "tet10", "--resolution", f"{1.25 * edge_m:.5f}"]
        return [kind, body, *size, "--out", out / "mesh.vtu"]
    arguments = [kind, EXAMPLES / example, "--resolution", f"{edge_m:.5f}"]
    return arguments if kind == "gradcheck" else arguments + ["--out", out / "results"]


def seconds_to_end(myoloop, arguments, after_s):
    """None if the command ended before the interrupt; infinite if it had to be killed."""
    job = subprocess.Popen([myoloop, *arguments, "--quiet"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        job.wait(after_s)
        return None
    except subprocess.TimeoutExpired:
        pass
    start = time.monotonic()
    job.send_signal(signal.SIGINT)
    try:
        job.wait(LIMIT_S)
        return time.monotonic() - start
    except subprocess.TimeoutExpired:
        job.kill()
        job.wait()
        return float("inf")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("myoloop")
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--after", default="1,4,12")
    parser.add_argument("--dofs", default=",".join(f"{n:.0f}" for n in DOFS))
    options = parser.parse_args()
    moments = [float(word) for word in options.after.split(",")]
    print(f"{'kind':10} {'DOF':>8} " + " ".join(f"{f'{after_s:g} s':>9}" for after_s in moments))
    for kind in options.kinds.split(","):
        for dofs in (float(word) for word in options.dofs.split(",")):
            cells = []
            for after_s in moments:
                with tempfile.TemporaryDirectory() as folder:
                    arguments = command(kind, dofs, pathlib.Path(folder))
                    taken_s = seconds_to_end(options.myoloop, arguments, after_s)
                cells.append("-" if taken_s is None else f"{taken_s:.2f}" + ("*" if taken_s > 1.0 else " "))
            print(f"{kind:10} {dofs:8.0f} " + " ".join(f"{cell:>9}" for cell in cells), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
