"""The toy's own controller, written again in Python: drives the way that it was told."""

import os
import struct
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples/python"))
import dockyard_client
from dockyard_client import BRAKE, DONE, UNDER_WAY, VELOCITY, Commands, Motor, serve


class Counting:
    def __init__(self, hello):
        self.way_m, self.speed_m_s = hello["nominal"]["distance_m"], hello["nominal"]["speed_m_s"]
        self.fault = sys.argv[1] if len(sys.argv) > 1 else ""

    def step(self, frame):
        gone_m = 0.1 * 1e-3 * frame.counts[0]
        if gone_m > 0.5 * self.way_m:
            self.misbehave()
        there = gone_m >= self.way_m
        motor = Motor(BRAKE if there else VELOCITY, self.speed_m_s / 0.1)
        phase = "\u00e9" * 100000 if self.fault == "long_phase" else "drive"
        belief = {"phase": phase, "x_m": self.way_m - gone_m, "y_m": 0.0, "heading_rad": 3.14159}
        self.believe_more(belief, gone_m, belief["x_m"])
        motors = [motor] if self.fault != "motors" else [motor, motor]
        stops = {"nan_stops": float("nan"), "far_stops": 7.0, "stops": -2.0}.get(self.fault, 0.0)
        verdict = DONE if there else UNDER_WAY
        return Commands(motors, verdict=verdict, belief=belief, exposure_stops=stops)

    def believe_more(self, belief, gone_m, left_m):
        late = {"=late": 2.0} if gone_m > left_m else {}
        level = [1, 0, 0, 0, 1, 0, 0, 0, 1]
        if self.fault == "values":
            belief["values"] = {"gone_m": gone_m, **late}
        if self.fault == "pose":
            belief["pose"] = {"R": level, "p_m": [left_m, 0, 0]}
        if self.fault == "bad_pose":
            belief["pose"] = {"R": level}
        if self.fault == "marks":  # this robot has no camera
            belief["marks"] = [{"id": 0, "camera": 0, "u_px": 1, "v_px": 1}]

    def misbehave(self):
        if self.fault == "crash":
            raise RuntimeError("the wheel fell off")
        if self.fault == "crash_in_bytes":
            os.write(2, b"bad \xff\xfe words\n")
            os._exit(3)
        if self.fault == "hang":
            time.sleep(60)
        if self.fault == "child":
            subprocess.Popen(["sleep", "60"])  # it keeps our standard output open
            os.write(2, b"left a child behind\n")
            os._exit(4)
        while self.fault == "believe":
            belief = b"{}"
            os.write(0, struct.pack("<I", len(belief)) + b"B" + belief)  # 0: the same socket
            time.sleep(0.01)
        if self.fault == "not_a_number":
            self.speed_m_s = float("nan")


HELLOS = {
    "deep_list": '{"protocol": ' + "[" * 300_000 + "]" * 300_000 + "}",
    "deep_object": '{"protocol":' * 60_000 + "3" + "}" * 60_000,
    "real_protocol": '{"protocol": 3.5}',
    "large_protocol": '{"protocol": 1e999}',
    "text_protocol": '{"protocol": "3"}',
    "listed": "[3]",
}
if sys.argv[1:] and sys.argv[1] in HELLOS:
    dockyard_client.json.dumps = lambda value: HELLOS[sys.argv[1]]
if sys.argv[1:] == ["first_protocol"]:
    dockyard_client.json.dumps = lambda value: '{"protocol": 1}'
serve(Counting)
