"""Ctrl-C: a KeyboardInterrupt soon after, in a session that goes on."""

import os
import subprocess
import sys

import pytest

pytestmark = pytest.mark.skipif(os.name == "nt", reason="a signal to a process of one's own is POSIX's")

# Python's own handler must be there throughout, and the session must be usable afterwards.
SESSION = """
import _thread, functools, os, pathlib, signal, tempfile, threading, time
# What a shell has started in the background ignores interrupts, and so do its children.
signal.signal(signal.SIGINT, signal.default_int_handler)
import gamow
import numpy as np

def interrupted(call, after=0.4, within=2.0):
    sent = []
    def interrupt():
        sent.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)
    threading.Timer(after, interrupt).start()
    try:
        call()
    except KeyboardInterrupt:
        # By the processors' time: that of a clock depends on what else the machine does.
        took = time.process_time() - sent[0]
        assert took < within, f"after {took} s"
    else:
        raise SystemExit("not interrupted")
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert gamow.disparity(beta=0.5, d=0.1, y=3, z=2, T=0)["dphi"] < 0

LARGE = {"renderer": "reference", "samples": 16, "size": "1280x960"}
STATE = gamow.State("street", **LARGE)
"""

CALLS = {
    "render": "interrupted(STATE.render)",
    "render by packets": "interrupted(lambda: gamow.render('lattice', renderer='packets', size='4096x4096'))",
    "channels": "interrupted(lambda: STATE.replace(size='2048x1536').render(channels=True))",
    "a picture in a notebook": "interrupted(STATE._repr_png_)",
    # The file of a frame that is whole is written to its end, so that a large one takes its time.
    "measure": "interrupted(lambda: gamow.measure(STATE.replace(size='400x300'), times=range(500), object='front tyre'), after=1)",
    "curve": "interrupted(lambda: gamow.curve(samples=10_000_000))",
    "sightings": "interrupted(lambda: gamow.sightings(beta=0.5, d=0.1, y=3, z=np.full(10_000_000, 2.0), T=0))",
    "disparity": "interrupted(lambda: gamow.disparity(beta=0.5, d=0.1, y=3, z=np.full(20_000_000, 2.0), T=0))",
    "fit": """
T = np.linspace(-5, 20, 200)
seen = gamow.disparity(beta=0.9, d=0.1, y=3, z=2, T=T)
noise = np.random.default_rng(1).normal(0, 1e-4, 200)
interrupted(lambda: gamow.fit({"T": T, "d": 0.1, "dphi": seen["dphi"] + noise}, bootstrap=10_000_000))
""",
    "waiting after a scene was saved": """
gamow.Scene({"name": "Ball", "object": [{"shape": "sphere", "centre": (0, 3, 2), "radius": 0.5}]}).save("ball.toml")
interrupted(lambda: time.sleep(20))
""",
    "waiting after a measurement": """
state = gamow.State(scene="cyclist", renderer="reference", samples=1, size="240x180")
gamow.measure(state, times=[1, 3], object="front tyre")
interrupted(lambda: time.sleep(20))
""",
}


def run(program, folder):
    environment = os.environ | {"TMPDIR": str(folder)}
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=folder, env=environment, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    assert "panicked" not in done.stderr
    return done.stdout


@pytest.mark.parametrize("name", CALLS)
def test_an_interrupt_is_an_exception_and_leaves_nothing(name, tmp_path):
    run(SESSION + CALLS[name], tmp_path)
    assert {path.name for path in tmp_path.iterdir()} <= {"ball.toml"}


@pytest.mark.parametrize("call", ["gamow.render, 'street', size='16x12', renderer='reference'", "gamow.curve, samples=3",
                                  "gamow.disparity, beta=0.5, d=0.1, y=3, z=2, T=[0.0, 1.0]"])
def test_an_interrupt_of_the_first_array_does_not_panic(call, tmp_path):
    # Nothing of Python runs between the two calls of `map`, so that the second begins under an interrupt.
    program = f"""
import _thread, functools, signal
import gamow
# A shell has it ignored for what it runs in the background.
signal.signal(signal.SIGINT, signal.default_int_handler)
calls = [_thread.interrupt_main, functools.partial({call})]
try:
    list(map(functools.partial.__call__, map(functools.partial, calls)))
    list(range(3))
except KeyboardInterrupt:
    print("interrupted")
"""
    assert run(program, tmp_path) == "interrupted\n"


def test_an_interrupt_in_another_thread_waits_for_the_main_one(tmp_path):
    program = SESSION + """
small = STATE.replace(size="320x240", samples=2)
pictures = []
thread = threading.Thread(target=lambda: pictures.append(small.render()))
thread.start()
interrupted(STATE.render)
thread.join()
# The thread's own picture was not given up.
assert (pictures[0] == small.render()).all()
print("whole")
"""
    assert run(program, tmp_path) == "whole\n"
