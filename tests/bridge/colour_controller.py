"""Answers with a number made of the colours that it saw, as the controller of colour_test.cc does."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../examples/python"))
from dockyard_client import DONE, UNDER_WAY, VELOCITY, Commands, Motor, serve


class Colour:
    def __init__(self, hello):
        self.camera = hello["nominal"]["colour_camera"]

    def step(self, frame):
        target, belief = 0.0, {}
        if self.camera in frame.images:
            image = frame.images[self.camera]
            assert (image.channels, image.width, image.height) == (3, 3, 2)
            assert image.exposed_ms == frame.tick_ms  # at once
            belief["marks"] = [{"id": 7, "camera": self.camera, "u_px": 2, "v_px": 0.5}]
            target = float(sum((i + 1) * value for i, value in enumerate(image.pixels)))
        verdict = DONE if frame.tick_ms >= 200 else UNDER_WAY
        motors = [Motor(VELOCITY, target)]
        return Commands(motors, cameras=[self.camera], verdict=verdict, belief=belief)


serve(Colour)
