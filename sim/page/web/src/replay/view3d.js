// The replay in three dimensions.

import {
  AmbientLight,
  Color,
  DirectionalLight,
  Fog,
  Group,
  HemisphereLight,
  LineBasicMaterial,
  LineDashedMaterial,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { makeGround } from './ground3d.js';
import { makeBody, makeBoard, TubeLine } from './parts3d.js';
import { compose } from './poses.js';
import { lay, makeLine, makeTrail } from './trails3d.js';

const SKY = 0xdfe5ea;
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
    this.scene.background = new Color(SKY);
    this.scene.fog = new Fog(SKY, 14, 45);
    this.camera = new PerspectiveCamera(38, 16 / 9, 0.05, 200);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.maxPolarAngle = 1.53;
    this.controls.addEventListener('change', () => this.render());
    this.following = false;
    this.time = 0;
    this.addLight();
    this.addParts(header, blobs);
    this.reset();
  }

  addLight() {
    const sun = new DirectionalLight(0xfff4e2, 2.6);
    const [x, y, z] = this.tracks.scene.sun_W ?? [0.4, -0.5, 0.8];
    sun.position.set(x, y, Math.max(0.25, z)).multiplyScalar(20);
    this.castShadows(sun);
    this.scene.add(
      sun,
      sun.target,
      new HemisphereLight(0xcfdcec, 0x8d7d68, 1.3),
      new AmbientLight(0xffffff, 0.25),
    );
  }

  /** The sun's shadows cover all that moves. @param {DirectionalLight} sun */
  castShadows(sun) {
    const [x0, y0, x1, y1] = this.tracks.extent();
    const reach = Math.hypot(x1 - x0, y1 - y0) / 2 + 1.5;
    sun.target.position.set((x0 + x1) / 2, (y0 + y1) / 2, 0);
    sun.position.add(sun.target.position);
    sun.castShadow = true;
    sun.shadow.mapSize.set(2048, 2048);
    sun.shadow.normalBias = 0.01;
    Object.assign(sun.shadow.camera, {
      left: -reach,
      right: reach,
      top: reach,
      bottom: -reach,
      near: 1,
      far: 40,
    });
  }

  /** @param {any} header @param {import('../payload.js').Blobs} blobs */
  addParts(header, blobs) {
    const { tracks, scene } = this;
    this.bodies = new Map();
    this.ghosts = new Map();
    const meshes = header.meshes ?? [];
    for (const { body } of tracks.bodies) {
      const described = tracks.scene.bodies[body];
      const group = makeBody(described, meshes, blobs, null);
      if (tracks.scene.board?.body === body) group.add(makeBoard(tracks.scene.board));
      this.bodies.set(body, group);
      scene.add(group);
      if (!described.robot || !tracks.believed) continue;
      const ghost = makeBody(described, meshes, blobs, BELIEF);
      this.ghosts.set(body, ghost);
      scene.add(ghost);
    }
    this.robot = tracks.bodies.find((/** @type {any} */ b) => tracks.scene.bodies[b.body].robot)?.body;
    this.lines = tracks.lines.map((/** @type {any} */ line) => new TubeLine(line));
    scene.add(...this.lines.map((/** @type {any} */ line) => line.mesh));
    this.ground = makeGround(tracks.ground, blobs, tracks.extent());
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

  /** The camera where it sees the whole way from the side. */
  reset() {
    const [x0, y0, x1, y1] = this.tracks.extent();
    const centre = new Vector3((x0 + x1) / 2, (y0 + y1) / 2, 0.25);
    const size = Math.hypot(x1 - x0, y1 - y0) + 0.9; // the robot reaches beyond its way
    const target = this.tracks.X_WD;
    const side = target[2] - 1.05; // from beside the axis, in front of the target
    this.controls.target.copy(centre);
    this.camera.position.set(
      centre.x + Math.cos(side) * size * 1.15,
      centre.y + Math.sin(side) * size * 1.15,
      0.25 + size * 0.62,
    );
    this.controls.update();
    this.render();
  }

  /** @param {boolean} following */
  follow(following) {
    this.following = following;
    if (following && this.robot !== undefined) this.moveCamera(this.bodies.get(this.robot).position);
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
    this.renderer.render(this.scene, this.camera);
  }

  /** @param {number} width @param {number} height */
  resize(width, height) {
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.render();
  }

  dispose() {
    this.controls.dispose();
    this.scene.traverse((/** @type {any} */ part) => part.geometry?.dispose());
    this.renderer.dispose();
    this.renderer.forceContextLoss();
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

/** Whether a processor draws in place of a graphics card: then smooth edges cost too much. Throws without WebGL. */
function probeSoftware() {
  const context = document.createElement('canvas').getContext('webgl2');
  if (!context) throw new Error('no WebGL');
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const name = names ? String(context.getParameter(names.UNMASKED_RENDERER_WEBGL)) : '';
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/** @param {any} group @param {number[] | undefined} pose */
function place(group, pose) {
  if (!pose) return;
  group.position.set(pose[0], pose[1], pose[2]);
  group.quaternion.set(pose[3], pose[4], pose[5], pose[6]);
}
