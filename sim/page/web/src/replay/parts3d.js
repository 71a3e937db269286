// Things of the scene in three dimensions: bodies of meshes, the board, lines with a diameter.

import {
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  Color,
  CylinderGeometry,
  DoubleSide,
  EdgesGeometry,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  PlaneGeometry,
  Quaternion,
  SRGBColorSpace,
  Vector3,
} from 'three';
import { paintBoard } from './board_picture.js';

const UP = new Vector3(0, 1, 0); // along a cylinder of three
const THINNEST = 0.008; // m; a tether of 3 mm could not be seen
const MOST_PIECES = 64;
const SHARP_DEG = 40; // edges that are drawn turn by more

/**
 * A body of its meshes, or, with a colour, its edges alone.
 * @param {any} body @param {any[]} meshes @param {import('../payload.js').Blobs} blobs @param {number | null} edges
 */
export function makeBody(body, meshes, blobs, edges) {
  const group = new Group();
  for (const part of body.parts ?? []) {
    const geometry = geometryOf(meshes[part.mesh], blobs);
    const mesh =
      edges === null
        ? new Mesh(
            geometry,
            new MeshLambertMaterial({
              color: new Color(...part.colour),
              flatShading: true,
              side: DoubleSide,
            }),
          )
        : new LineSegments(
            new EdgesGeometry(geometry, SHARP_DEG),
            new LineBasicMaterial({ color: edges, transparent: true, opacity: 0.55 }),
          );
    mesh.castShadow = mesh.receiveShadow = edges === null;
    mesh.position.set(.../** @type {[number, number, number]} */ (part.position ?? [0, 0, 0]));
    mesh.quaternion.set(.../** @type {[number, number, number, number]} */ (part.quaternion ?? [0, 0, 0, 1]));
    group.add(mesh);
  }
  return group;
}

/** @param {any} mesh @param {import('../payload.js').Blobs} blobs */
function geometryOf(mesh, blobs) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(blobs.f32(mesh.vertices), 3));
  geometry.setIndex(new BufferAttribute(blobs.u32(mesh.triangles), 1));
  geometry.computeVertexNormals();
  return geometry;
}

/** @param {any} board */
export function makeBoard(board) {
  const texture = new CanvasTexture(paintBoard(board));
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 4;
  const plate = new Mesh(
    new PlaneGeometry(board.width_m, board.height_m),
    new MeshLambertMaterial({ map: texture, alphaTest: 0.5, side: DoubleSide }),
  );
  plate.rotation.x = Math.PI; // the plane's y is up and it faces +z; the board's y is down, z away from its beholder
  const group = new Group();
  group.add(plate);
  const turn = new Quaternion(.../** @type {[number, number, number, number]} */ (board.quaternion));
  const ahead = new Vector3(0, 0, -0.003).applyQuaternion(turn); // so that it does not flicker in the face behind it
  group.position.set(.../** @type {[number, number, number]} */ (board.position)).add(ahead);
  group.quaternion.copy(turn);
  return group;
}

/** A line through points as short cylinders. */
export class TubeLine {
  /** @param {any} line */
  constructor(line) {
    const radius = Math.max(THINNEST, line.diameter_m ?? 0) / 2;
    this.mesh = new InstancedMesh(
      new CylinderGeometry(radius, radius, 1, 6, 1, true),
      new MeshLambertMaterial({ color: new Color(...(line.colour ?? [0.05, 0.05, 0.05])) }),
      MOST_PIECES,
    );
    this.mesh.castShadow = true;
    this.mesh.frustumCulled = false;
    this.mesh.count = 0;
  }

  /** @param {number[][]} points in W */
  update(points) {
    const matrix = new Matrix4(),
      turn = new Quaternion();
    const a = new Vector3(),
      b = new Vector3(),
      way = new Vector3();
    const pieces = Math.min(MOST_PIECES, Math.max(0, points.length - 1));
    for (let i = 0; i < pieces; ++i) {
      a.fromArray(points[i]);
      b.fromArray(points[i + 1]);
      way.subVectors(b, a);
      const length = Math.max(1e-6, way.length());
      turn.setFromUnitVectors(UP, way.divideScalar(length));
      matrix.compose(a.add(b).multiplyScalar(0.5), turn, new Vector3(1, length, 1));
      this.mesh.setMatrixAt(i, matrix);
    }
    this.mesh.count = pieces;
    this.mesh.instanceMatrix.needsUpdate = true;
  }
}

/** @param {any} group @param {number[] | undefined} pose */
export function place(group, pose) {
  if (!pose) return;
  group.position.set(pose[0], pose[1], pose[2]);
  group.quaternion.set(pose[3], pose[4], pose[5], pose[6]);
}
