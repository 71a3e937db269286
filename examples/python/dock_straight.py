"""Docks Axel from straight ahead: looks once, then lets the tether pull the rover into the cone.

The wheels roll free, the arm is held, the spool reels in until it stalls. Tsai et al. (2013), V-C:
below 5 deg off the cone's axis that is enough.
"""

from dockyard_client import DONE, FREE, POSITION, UNDER_WAY, VELOCITY, Commands, Motor, serve

LEFT_WHEEL, RIGHT_WHEEL, ARM, SPOOL = range(4)
REEL_M_S = 0.05  # assumed, 0.03-0.10
PULL_N = 300.0  # what a forced fit into the cone takes; assumed, 105-300
SQUARE_PX = 40  # half of the mouth's width in an image from 2 m
STALLED_S, STALL_M = 2.0, 0.002  # no more than this taken up for that long: reeled in


class DockStraight:
    def __init__(self, hello):
        self.nominal = hello["nominal"]
        spool = self.nominal["motors"][SPOOL]
        self.drum_m = self.nominal["drum_radius_m"]
        self.count_m = self.drum_m * spool["rad_per_count"]
        self.pull_a = spool["no_load_current_a"] + PULL_N * self.drum_m / spool["torque_per_amp_nm"]
        self.pull_a = min(self.pull_a, spool["max_current_a"])
        self.reeled_m, self.still_since_s = 0.0, 0.0
        self.looked = False

    def step(self, frame):
        belief = {}
        if frame.images:
            belief["marks"] = self.locate(frame.images[0])  # with the frame that brought the image
        reeled_m = self.count_m * frame.counts[SPOOL]
        if abs(reeled_m - self.reeled_m) > STALL_M:
            self.reeled_m, self.still_since_s = reeled_m, frame.time_s
        reeled_in = frame.time_s - self.still_since_s > STALLED_S
        arm = self.nominal["motors"][ARM]
        motors = [Motor() if reeled_in else Motor(FREE) for _ in range(4)]
        motors[ARM] = Motor(POSITION, 0.0, 0.17, 1.0, arm["max_current_a"])
        if not reeled_in:
            motors[SPOOL] = Motor(VELOCITY, REEL_M_S / self.drum_m, 0.0, 2.0, self.pull_a)
        ask = () if self.looked else (0,)  # one image of the left camera
        self.looked = True
        belief["phase"] = "docked" if reeled_in else "reel"
        belief["values"] = {  # they are in values.csv, in the log and in the report
            "reeled_m": reeled_m,
            "still_s": frame.time_s - self.still_since_s,
        }
        verdict = DONE if reeled_in else UNDER_WAY
        return Commands(motors, cameras=ask, verdict=verdict, belief=belief)

    def locate(self, image):
        """Marks the darkest square in the middle half of the image: it lies in the cone's mouth. Plain
        Python will do for that; Image.array() gives a numpy array."""
        wide, high, pixels = image.width, image.height, image.pixels

        def light(corner):
            u, v = corner
            rows = range(v * wide + u, (v + SQUARE_PX) * wide + u, wide)
            return sum(sum(pixels[at : at + SQUARE_PX]) for at in rows)

        us = range(wide // 4, 3 * wide // 4 - SQUARE_PX, SQUARE_PX // 4)
        vs = range(high // 4, 3 * high // 4 - SQUARE_PX, SQUARE_PX // 4)
        u, v = (at + SQUARE_PX // 2 for at in min(((u, v) for u in us for v in vs), key=light))
        print("image of %d x %d, darkest at (%d, %d)" % (wide, high, u, v))
        return [{"id": 0, "camera": image.camera, "u_px": u, "v_px": v}]


if __name__ == "__main__":
    serve(DockStraight)
