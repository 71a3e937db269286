"""Docks by a tag in 60 lines: finds it with OpenCV, drives to the dock's axis, then along it until
the charger's voltage is there. Needs Debian's python3-opencv."""

import math
import sys

import cv2
import numpy

sys.path.insert(0, "../../python")
from dockyard_client import BRAKE, DONE, GIVEN_UP, UNDER_WAY, Commands, Motor, Wheels, serve


class DockByTag:
    def __init__(self, hello):
        self.nominal = hello["nominal"]
        self.wheels = Wheels(self.nominal)
        self.volts = self.nominal["sensors"].index("charge_voltage_v")
        camera, board = self.nominal["cameras"][0], self.nominal["boards"][0]
        lens = camera["camera"]
        self.K = numpy.array([[lens["fx"], 0, lens["cx"]], [0, lens["fy"], lens["cy"]], [0, 0, 1]])
        self.X_RC, self.X_DB = matrix(camera["X_RC"]), matrix(board["X_DB"])
        self.size = board["board"]["tags"][0]["size_m"]
        self.tags = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11)
        self.reach = self.nominal["X_RP"]["p_m"][0]
        self.X_OD = None  # the dock in odometry's frame
        self.charged = 0

    def step(self, frame):
        X_OR = planar(*self.wheels.update(frame))
        for image in frame.images.values():
            self.locate(image, X_OR)
        self.charged = self.charged + 1 if frame.values[self.volts] > 9 else 0
        if self.charged > 25:
            return Commands([Motor(BRAKE)] * 2, verdict=DONE)
        verdict = GIVEN_UP if frame.time_s > 100 else UNDER_WAY
        if self.X_OD is None:  # turn until a tag comes into view
            return Commands(self.wheels.motors(0, 0.3), (0,), verdict=verdict)
        X_DR = numpy.linalg.inv(self.X_OD) @ X_OR
        x, y = X_DR[0, 3] - self.reach, X_DR[1, 3]
        heading = math.atan2(-X_DR[1, 0], -X_DR[0, 0])  # 0: towards the dock
        aim = math.atan2(y, max(0.35 * x, 0.05)) if x > 0.05 else 0.0
        turn = max(-0.6, min(0.6, 2.0 * (aim - heading)))
        speed = 0.0 if abs(turn) > 0.55 else max(0.03, min(0.2, 0.5 * x))
        belief = {"x_m": X_DR[0, 3], "y_m": y, "heading_rad": math.atan2(X_DR[1, 0], X_DR[0, 0])}
        return Commands(self.wheels.motors(speed, turn), (0,), verdict=verdict, belief=belief)

    def locate(self, image, X_OR):
        corners, ids, _ = cv2.aruco.detectMarkers(image.array(), self.tags)
        if ids is None:
            return
        half = 0.5 * self.size  # OpenCV names an AprilTag's corners half a turn off its print
        points = numpy.array([[half, half, 0], [-half, half, 0], [-half, -half, 0], [half, -half, 0]])
        _, turn, place = cv2.solvePnP(points, corners[0][0], self.K, None, flags=cv2.SOLVEPNP_IPPE)
        X_CB = numpy.identity(4)
        X_CB[:3, :3], X_CB[:3, 3] = cv2.Rodrigues(turn)[0], place[:, 0]
        self.X_OD = X_OR @ self.X_RC @ X_CB @ numpy.linalg.inv(self.X_DB)


def matrix(pose):
    X = numpy.identity(4)
    X[:3, :3], X[:3, 3] = numpy.array(pose["R"]).reshape(3, 3), pose["p_m"]
    return X


def planar(x, y, heading):
    cos, sin = math.cos(heading), math.sin(heading)
    return numpy.array([[cos, -sin, 0, x], [sin, cos, 0, y], [0, 0, 1, 0], [0, 0, 0, 1.0]])


serve(DockByTag)
