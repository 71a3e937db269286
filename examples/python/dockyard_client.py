"""Talks to the Dockyard testbed: sensor frames come in, commands go out, in lock step.

Python's standard library only; numpy is needed for images alone (Image.array). Every byte of the
protocol is in docs/reference/controller_protocol.md.

    class MyController:
        def __init__(self, hello): ...          # hello["nominal"]: what the robot is known to be
        def step(self, frame): return Commands(...)

    serve(MyController)
"""

import json
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
