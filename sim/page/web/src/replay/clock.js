// Time of a replay: plays, stops, steps.

export class Clock {
  /** @param {number} end_s @param {number} step_s @param {() => void} changed called after each change */
  constructor(end_s, step_s, changed) {
    this.end_s = end_s;
    this.step_s = step_s;
    this.changed = changed;
    this.time = 0;
    this.speed = 5;
    this.playing = false;
    this.request = 0;
    this.last = 0;
  }

  /** @param {number} time */
  goTo(time) {
    this.time = Math.min(this.end_s, Math.max(0, time));
    this.changed();
  }

  /** To the next or last sample. @param {number} steps */
  step(steps) {
    this.stop();
    const here = this.time / this.step_s;
    const place = steps > 0 ? Math.floor(here + 1e-6) + steps : Math.ceil(here - 1e-6) + steps;
    this.goTo(place * this.step_s);
  }

  toggle() {
    if (this.playing) this.stop();
    else this.play();
  }

  play() {
    if (this.time >= this.end_s) this.time = 0;
    this.playing = true;
    this.last = performance.now();
    this.request = requestAnimationFrame((now) => this.tick(now));
    this.changed();
  }

  /** @param {number} now */
  tick(now) {
    if (!this.playing) return;
    const passed = Math.max(0, now - this.last) / 1000;
    this.last = now;
    const time = this.time + passed * this.speed;
    if (time >= this.end_s) this.playing = false;
    else this.request = requestAnimationFrame((next) => this.tick(next));
    this.goTo(time);
  }

  stop() {
    this.playing = false;
    cancelAnimationFrame(this.request);
    this.changed();
  }
}
