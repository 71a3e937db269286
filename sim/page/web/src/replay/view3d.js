// The replay in three dimensions.

import {
  Color,
  Fog,
  Group,
  LineBasicMaterial,
  LineDashedMaterial,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { cornersOf, firstView } from './first_view.js';
import { framedCorners, framedPoint } from './framing.js';
import { makeGround } from './ground3d.js';
import { makeBody, makeBoard, place, TubeLine } from './parts3d.js';
import { compose } from './poses.js';
import { addLight } from './light3d.js';
import { HORIZON, makeSky } from './sky3d.js';
import { probeSoftware } from './software.js';
import { lay, makeLine, makeTrail } from './trails3d.js';

const FOV_DEG = 38;
const TRUTH = 0x1f5fa8;
const BELIEF = 0xd9780f;
const PLAN = 0x1c8a5a;

export class View3d {
  /**
   * Throws where there is no WebGL.
   * @param {import('./tracks.js').Tracks} tracks
   * @param {any} header
   * @param {import('../payload.js').Blobs} blobs
   */
  constructor(tracks, header, blobs) {
    const drawn_in_software = probeSoftware();
    this.tracks = tracks;
    this.canvas = document.createElement('canvas');
    this.canvas.className = 'stage';
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute(
      'aria-label',
      'The run in three dimensions. Drag to turn, wheel to zoom, right button to move.',
    );
    this.renderer = new WebGLRenderer({
      canvas: this.canvas,
      antialias: !drawn_in_software,
      preserveDrawingBuffer: true,
    });
    this.renderer.setPixelRatio(drawn_in_software ? 1 : Math.min(2, window.devicePixelRatio));
    this.renderer.shadowMap.enabled = !drawn_in_software;
    this.scene = new Scene();
    this.scene.background = new Color(HORIZON);
    this.scene.fog = new Fog(HORIZON, 14, 90);
    this.sky = makeSky();
    this.scene.add(this.sky);
    this.camera = new PerspectiveCamera(FOV_DEG, 16 / 9, 0.05, 2000);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.maxPolarAngle = 1.53;
    this.controls.maxDistance = 150;
    this.controls.addEventListener('change', () => this.render());
    this.controls.addEventListener('start', () => {
      this.moved = true;
    });
    this.moved = false; // by the user: then a new size does not move it
    this.following = false;
    this.is_near = false;
    this.time = 0;
    addLight(this.scene, tracks);
    this.addParts(header, blobs, drawn_in_software ? 2 : 8);
    this.corners = cornersOf(tracks, this.bodies);
    this.draw(0);
    this.reset();
  }

  /** @param {any} header @param {import('../payload.js').Blobs} blobs @param {number} sharpness of the ground */
  addParts(header, blobs, sharpness) {
    const { tracks, scene } = this;
    this.bodies = new Map();
    this.ghosts = new Map();
    const meshes = header.meshes ?? [];
    for (const { body } of tracks.bodies) {
      const described = tracks.scene.bodies[body];
      const group = makeBody(described, meshes, blobs, null);
      for (const board of tracks.scene.boards ?? []) {
        if (board.body === body) group.add(makeBoard(board));
      }
      this.bodies.set(body, group);
      scene.add(group);
      if (!described.robot || !tracks.believed) continue;
      const ghost = makeBody(described, meshes, blobs, BELIEF);
      this.ghosts.set(body, ghost);
      scene.add(ghost);
    }
    this.robot = tracks.bodies.find((/** @type {any} */ b) => tracks.scene.bodies[b.body].robot)?.body;
    this.lines = tracks.lines.map((/** @type {any} */ line) => new TubeLine(line));
    for (const line of this.lines) scene.add(line.mesh);
    this.ground = makeGround(tracks.ground, blobs, tracks.extent(), {
      colour: tracks.scene.ground,
      sharpness,
    });
    scene.add(this.ground.group);
    const { ground } = this;
    this.truth = makeTrail(tracks, ground, 'truth', new LineBasicMaterial({ color: TRUTH }), 0.012);
    this.belief = makeTrail(
      tracks,
      ground,
      'believed',
      new LineDashedMaterial({ color: BELIEF, dashSize: 0.05, gapSize: 0.035 }),
      0.016,
    );
    this.plan = makeLine(new LineBasicMaterial({ color: PLAN }));
    this.plan_shown = -2;
    this.overlay = new Group();
    this.overlay.add(this.truth.line, this.belief.line, this.plan);
    scene.add(this.overlay);
  }

  /** The camera where it sees robot and target, over the whole run. */
  reset() {
    this.moved = false;
    this.aim();
    this.render();
  }

  aim() {
    if (this.corners.length === 0) return;
    const { from, centre, distance } = firstView(this.tracks, this.corners, FOV_DEG, this.camera.aspect);
    this.controls.target.copy(centre);
    this.camera.position.copy(from);
    const fog = /** @type {Fog} */ (this.scene.fog);
    fog.near = 1.5 * distance + 5;
    fog.far = 8 * distance + 60;
    this.controls.update();
  }

  /** @param {boolean} following */
  follow(following) {
    this.following = this.moved = following;
    if (following && this.robot !== undefined) this.moveCamera(this.bodies.get(this.robot).position);
    this.render();
  }

  /** The target's point from near, in the direction that the data have. @param {boolean} is_near */
  goNear(is_near) {
    this.is_near = this.moved = is_near;
    const point = this.tracks.nearPoint(this.time);
    if (is_near && point) {
      this.controls.target.set(point[0], point[1], point[2]);
      this.camera.position.copy(this.controls.target).add(new Vector3(...this.tracks.near.out));
      this.controls.update();
    }
    this.render();
  }

  /** Moves the camera with its target. @param {Vector3} point */
  moveCamera(point) {
    const step = new Vector3(point.x, point.y, point.z).sub(this.controls.target);
    this.camera.position.add(step);
    this.controls.target.add(step);
  }

  /** @param {number} time */
  draw(time) {
    this.time = time;
    const poses = this.tracks.poses(time);
    for (const [body, pose] of poses) place(this.bodies.get(body), pose);
    const ghost = this.tracks.ghost(time);
    for (const [body, group] of this.ghosts) {
      group.visible = ghost !== null;
      if (ghost) place(group, ghost.get(body));
    }
    const { sample } = this.tracks.place(time);
    this.ground.goTo(sample);
    this.tracks.lines.forEach((/** @type {any} */ line, /** @type {number} */ i) =>
      this.lines[i].update(this.tracks.linePoints(line, time)),
    );
    this.drawTrails(time, sample);
    if (this.following && this.robot !== undefined) this.moveCamera(this.bodies.get(this.robot).position);
    const point = this.is_near ? this.tracks.nearPoint(time) : null;
    if (point) this.moveCamera(new Vector3(...point));
    this.controls.update();
    this.render();
  }

  /** @param {number} time @param {number} sample */
  drawTrails(time, sample) {
    const plan = this.tracks.latest(this.tracks.plans, time);
    if (plan !== this.plan_shown) {
      this.plan_shown = plan;
      const points =
        plan < 0
          ? []
          : this.tracks.plans[plan].points.map((/** @type {number[]} */ p) =>
              compose(this.tracks.X_WD, [p[0], p[1], 0]),
            );
      lay(this.plan, this.ground, points, 0.02);
    }
    for (const { line, until } of [this.truth, this.belief]) line.geometry.setDrawRange(0, until[sample]);
  }

  render() {
    this.sky.position.copy(this.camera.position);
    this.renderer.render(this.scene, this.camera);
  }

  /** @param {number} width @param {number} height */
  resize(width, height) {
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (!this.moved) this.aim();
    this.render();
  }

  dispose() {
    this.controls.dispose();
    this.scene.traverse((/** @type {any} */ part) => part.geometry?.dispose());
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Ends of robot and target in the image. */
  framed() {
    return framedCorners(this.corners, this.camera);
  }

  /** Where the target's point is in the image, and how far off; or null. */
  framedNear() {
    return framedPoint(this.tracks.nearPoint(this.time), this.camera);
  }

  /** Where a body is drawn. @returns {Record<string, number[]>} */
  drawn() {
    return Object.fromEntries(
      [...this.bodies].map(([body, group]) => [
        this.tracks.scene.bodies[body].name,
        [...group.position.toArray(), ...group.quaternion.toArray()],
      ]),
    );
  }
}
