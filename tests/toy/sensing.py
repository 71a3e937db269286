"""Drives as the toy's own controller does, and prints all that its sensors by name give."""

import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples/python"))
from dockyard_client import DONE, VELOCITY, Commands, Motor, serve


class Sensing:
    def __init__(self, hello):
        self.path_m = hello["nominal"]["distance_m"]
        print(json.dumps(hello["sensors"]))

    def step(self, frame):
        print(json.dumps([frame.tick_ms, *frame.values]))
        commands = Commands([Motor(VELOCITY, 20.0)])
        if frame.values[0] >= self.path_m:
            commands.verdict = DONE
        return commands


serve(Sensing)
