"""Talks to the Dockyard testbed: sensor frames come in, commands go out, in lock step.

Python's standard library only; numpy is needed for images alone (Image.array). Every byte of the
protocol is in docs/reference/controller_protocol.md.

    class MyController:
        def __init__(self, hello): ...          # hello["nominal"]: what the robot is known to be
        def step(self, frame): return Commands(...)

    serve(MyController)
"""

import json
import math
import os
import struct
import sys

PROTOCOL = 4
FREE, BRAKE, VELOCITY, POSITION = range(4)  # modes of a motor
UNDER_WAY, DONE, GIVEN_UP = range(3)  # verdicts


class Motor:
    """A command for one motor, all at its output shaft (rad, rad/s, rad/s^2, A)."""

    def __init__(self, mode=BRAKE, target=0.0, speed_limit=0.0, accel=0.0, current_limit=0.0):
        self.mode, self.target, self.speed_limit = mode, target, speed_limit
        self.accel, self.current_limit = accel, current_limit


class Wheels:
    """Twists and odometry for the wheels of hello["nominal"] of a robot by files: driven wheels
    anywhere on the body, fixed or steered. Casters and balls follow. Only driven wheels count."""

    def __init__(self, nominal, accel_m_s2=1.0):
        self.drives, self.accel = nominal["motors"], accel_m_s2
        self.wheels = [w for w in nominal["wheels"] if w["drive"] >= 0]
        self.x = self.y = self.heading = 0.0  # since power-on
        self.counts = None

    def _forward(self, wheel):
        """Where the wheel rolls when its motor turns positively: axle x up."""
        return wheel["axle_R"][1], -wheel["axle_R"][0]

    def motors(self, forward_m_s, turn_rad_s, others=None):
        """Commands for all motors; those that move no wheel brake, or are as `others` has them by
        their number."""
        if not (math.isfinite(forward_m_s) and math.isfinite(turn_rad_s)):
            raise ValueError("speeds: expected finite numbers, found %s and %s" % (forward_m_s, turn_rad_s))
        motors = [(others or {}).get(i, Motor()) for i in range(len(self.drives))]
        for wheel in self.wheels:
            fx, fy = self._forward(wheel)
            at = wheel["p_RS"] if wheel["steering"] >= 0 else wheel["p_RK"]
            vx, vy = forward_m_s - turn_rad_s * at[1], turn_rad_s * at[0]
            speed = fx * vx + fy * vy
            if wheel["steering"] >= 0 and math.hypot(vx, vy) > 1e-6:
                angle = math.atan2(fx * vy - fy * vx, speed)
                if abs(angle) > 0.5 * math.pi:  # backwards is nearer
                    angle -= math.copysign(math.pi, angle)
                speed = math.copysign(math.hypot(vx, vy), speed)
                steer = self.drives[wheel["steering"]]["motor"]
                motors[wheel["steering"]] = Motor(
                    POSITION, angle, steer["max_speed_rad_s"], steer["max_accel_rad_s2"],
                    steer["max_current_a"])  # fmt: skip
            drive = self.drives[wheel["drive"]]["motor"]
            limit = drive["max_speed_rad_s"]
            target = max(-limit, min(limit, speed / wheel["radius_m"]))
            motors[wheel["drive"]] = Motor(
                VELOCITY, target, 0.0, self.accel / wheel["radius_m"], drive["max_current_a"])  # fmt: skip
        return motors

    def update(self, frame):
        """Takes in a frame's encoders: x, y [m] and heading [rad] since power-on, by the twist that
        fits all driven wheels best (least squares). Call it for every frame."""
        counts, last = frame.counts, self.counts or frame.counts
        self.counts = counts
        angle = [
            (counts[i] - last[i]) * drive["motor"]["rad_per_count"]
            for i, drive in enumerate(self.drives)
        ]
        a = b = c = p = q = 0.0  # of the normal equations for forward and turn
        for wheel in self.wheels:
            fx, fy = self._forward(wheel)
            at = wheel["p_RS"] if wheel["steering"] >= 0 else wheel["p_RK"]
            if wheel["steering"] >= 0:
                i = wheel["steering"]
                turned = counts[i] * self.drives[i]["motor"]["rad_per_count"]
                cos, sin = math.cos(turned), math.sin(turned)
                fx, fy = cos * fx - sin * fy, sin * fx + cos * fy
            lever = fy * at[0] - fx * at[1]
            rolled = angle[wheel["drive"]] * wheel["radius_m"]
            a, b, c = a + fx * fx, b + fx * lever, c + lever * lever
            p, q = p + fx * rolled, q + lever * rolled
        det = a * c - b * b
        ahead, turn = ((c * p - b * q) / det, (a * q - b * p) / det) if det > 1e-12 else (p / a, 0.0)
        middle = self.heading + 0.5 * turn
        self.x += ahead * math.cos(middle)
        self.y += ahead * math.sin(middle)
        self.heading += turn
        return self.x, self.y, self.heading


class Commands:
    """What the robot is to do until the next frame. `belief` is for the run's record alone: phase,
    note, x_m, y_m, heading_rad (in the target's frame; z_m, roll_rad, pitch_rad too), values (a dict of numbers), marks (what was
    found in an image), pose (of the target in the robot's body). The cameras take their images
    `exposure_stops` off the exposure that they choose: +1 is twice the light."""

    def __init__(
        self, motors, cameras=(), switches=(), verdict=UNDER_WAY, belief=None, exposure_stops=0.0
    ):
        self.motors, self.cameras, self.switches = motors, cameras, switches
        self.verdict, self.belief, self.exposure_stops = verdict, belief, exposure_stops


class Image:
    """What one camera took: 8 bits a channel, row by row from the top left."""

    def __init__(self, camera, exposed_ms, exposure_s, channels, width, height, pixels):
        self.camera, self.channels, self.width, self.height = camera, channels, width, height
        self.exposed_ms = exposed_ms  # on the frames' clock; earlier than the frame if it came late
        self.exposure_s = exposure_s  # nominal
        self.pixels = pixels  # bytes

    def array(self):
        """The image as a numpy array, height x width for grey, height x width x 3 for colour."""
        import numpy

        shape = (self.height, self.width) + ((3,) if self.channels == 3 else ())
        return numpy.frombuffer(self.pixels, dtype=numpy.uint8).reshape(shape)


class Frame:
    """What the sensors say at one tick. Angles in rad, rates in rad/s, forces in m/s^2."""

    def __init__(self, payload):
        values = struct.unpack_from("<q9dI", payload, 0)
        self.tick_ms = values[0]
        self.roll, self.pitch, self.yaw = values[1:4]
        self.rate, self.specific_force = values[4:7], values[7:10]
        at = struct.calcsize("<q9dI")
        self.counts, self.currents = [], []
        for _ in range(values[10]):
            counts, current = struct.unpack_from("<qd", payload, at)
            self.counts.append(counts)
            self.currents.append(current)
            at += 16
        count = struct.unpack_from("<I", payload, at)[0]
        self.values = struct.unpack_from("<%dd" % count, payload, at + 4)  # as hello["sensors"]
        at += 4 + 8 * count
        image_count = struct.unpack_from("<BI", payload, at)[1]
        at += 5
        self.images = {}
        for _ in range(image_count):
            camera, exposed_ms, exposure_s, kind, width, height, size = struct.unpack_from(
                "<IqdBIII", payload, at
            )
            at += 33
            pixels = payload[at : at + size]
            self.images[camera] = Image(
                camera, exposed_ms, exposure_s, 3 if kind == 1 else 1, width, height, pixels
            )
            at += size

    @property
    def time_s(self):
        return 1e-3 * self.tick_ms


def _read(stream, count):
    """Exactly so many bytes; None at the end of the stream."""
    data = bytearray()
    while len(data) < count:
        block = stream.read(count - len(data))
        if not block:
            return None
        data += block
    return bytes(data)


def _receive(stream):
    head = _read(stream, 5)
    if head is None:
        return None, b""
    length, kind = struct.unpack("<Ic", head)
    return kind, _read(stream, length)


def _message(kind, payload):
    return struct.pack("<Ic", len(payload), kind) + payload


def _commands(commands):
    out = struct.pack("<I", len(commands.motors))
    for m in commands.motors:
        out += struct.pack("<B4d", m.mode, m.target, m.speed_limit, m.accel, m.current_limit)
    out += struct.pack("<I%dI" % len(commands.cameras), len(commands.cameras), *commands.cameras)
    out += struct.pack("<I%dB" % len(commands.switches), len(commands.switches), *commands.switches)
    return out + struct.pack("<Bd", commands.verdict, commands.exposure_stops)


def serve(make_controller):
    """Makes a controller from the testbed's hello and answers every frame, until the testbed says
    good-bye. What the controller prints goes to standard error, so that it cannot disturb the
    answers."""
    source = os.fdopen(os.dup(0), "rb", buffering=1 << 16)
    sink = os.fdopen(os.dup(1), "wb", buffering=0)
    sys.stdout = sys.stderr
    os.dup2(2, 1)
    kind, payload = _receive(source)
    if kind != b"H":
        raise SystemExit("expected the testbed's hello; start me by a scenario's controller.command")
    hello = json.loads(payload)
    if hello["protocol"] != PROTOCOL:
        raise SystemExit("the testbed speaks protocol %s, I speak %d" % (hello["protocol"], PROTOCOL))
    sink.write(_message(b"H", json.dumps({"protocol": PROTOCOL}).encode()))
    controller = make_controller(hello)
    while True:
        kind, payload = _receive(source)
        if kind != b"F":
            return
        commands = controller.step(Frame(payload))
        answer = _message(b"C", _commands(commands))
        if commands.belief is not None:
            answer = _message(b"B", json.dumps(commands.belief).encode()) + answer
        sink.write(answer)
