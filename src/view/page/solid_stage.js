// The stage of three dimensions: three.js, one instanced mesh for all balls.

import {AmbientLight, BoxGeometry, BufferAttribute, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DirectionalLight, DoubleSide, DynamicDrawUsage, EdgesGeometry, IcosahedronGeometry, InstancedMesh,
  LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, PerspectiveCamera, PlaneGeometry, Quaternion, Scene, SphereGeometry, Vector3, WebGLRenderer} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {extentOf} from './extent.js';
import {KIND} from './log.js';
import {drift} from './walls.js';

const MOST_ARROWS = 20000;

export class SolidStage {
  constructor(canvas, replay, colours, options) {
    Object.assign(this, {canvas, replay, colours, options});
    this.renderer = new WebGLRenderer({canvas, antialias: true});
    this.world = new Scene();
    this.camera = new PerspectiveCamera(35, 1, 0.001, 1000);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => options.changed());
    this.extent = extentOf(replay);
    this.size = Math.max(...[0, 1, 2].map((k) => this.extent.upper[k] - this.extent.lower[k]));
    this.middle = new Vector3(...[0, 1, 2].map((k) => (this.extent.upper[k] + this.extent.lower[k]) / 2));
    this.shifts = [[0, 0, 0]];
    this.addLights();
    this.addSpace();
    this.addWalls();
    this.addBalls();
    this.trails = this.addLines(true);
    this.arrows = new Arrows(this.world, false);
    this.marks = new Arrows(this.world, true);
    this.resize();
    this.fit();
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.listen();
  }

  addLights() {
    this.world.add(new AmbientLight(0xffffff, 1.4));
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(0.4, -0.7, 1);
    this.world.add(sun);
  }

  addSpace() {
    const {scene} = this.replay, {lower, upper} = this.extent;
    if (scene.space.kind === 'open') return;
    const box = new BoxGeometry(...[0, 1, 2].map((k) => upper[k] - lower[k]));
    this.frame = new LineSegments(new EdgesGeometry(box), new LineBasicMaterial({color: this.colours.page.wall}));
    this.frame.position.copy(this.middle);
    this.world.add(this.frame);
  }

  addWalls() {
    this.walls = [];
    for (const wall of this.replay.scene.walls) {
      const material = new MeshLambertMaterial({color: this.colours.page.wall, transparent: true, opacity: wall.side === 'outside' ? 0.85 : 0.15, side: DoubleSide, depthWrite: wall.side === 'outside'});
      let mesh = null;
      if (wall.kind === 'circle') {
        mesh = new Mesh(new SphereGeometry(wall.radius, 48, 32), material);
        mesh.position.set(...wall.centre);
      } else if (wall.kind === 'plane') {
        mesh = new Mesh(new PlaneGeometry(1.4 * this.size, 1.4 * this.size), material);
        mesh.position.set(...wall.point);
        mesh.lookAt(new Vector3(...wall.point).add(new Vector3(...wall.normal)));
      }
      if (!mesh) continue;
      mesh.userData = {at: mesh.position.clone(), wall};
      this.walls.push(mesh);
      this.world.add(mesh);
    }
  }

  addBalls() {
    const {log, scene} = this.replay;
    const detail = log.balls <= 200 ? 5 : log.balls <= 3000 ? 3 : 2;
    const most = log.balls * (scene.space.kind === 'periodic' ? 27 : 1);
    this.geometry = new IcosahedronGeometry(1, detail);
    this.material = new MeshLambertMaterial({color: 0xffffff});
    this.balls = new InstancedMesh(this.geometry, this.material, log.balls);
    this.balls.frustumCulled = false;
    this.balls.instanceMatrix.setUsage(DynamicDrawUsage);
    this.ghosts = null;
    this.mostGhosts = most - log.balls;
    this.world.add(this.balls);
    this.matrix = new Matrix4();
    this.colour = new Color();
    for (let i = 0; i < log.balls; ++i) this.balls.setColorAt(i, this.colour.set('#888'));
  }

  addLines(vertexColours) {
    const lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({vertexColors: vertexColours, transparent: true}));
    lines.frustumCulled = false;
    this.world.add(lines);
    return lines;
  }

  setLines(lines, points, colours) {
    lines.geometry.dispose();
    lines.geometry = new BufferGeometry();
    lines.geometry.setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
    if (colours) lines.geometry.setAttribute('color', new BufferAttribute(new Float32Array(colours), 3));
    lines.visible = points.length > 0;
  }

  resize() {
    const {clientWidth: w, clientHeight: h} = this.canvas;
    if (w === 0 || h === 0) return;
    this.width = w;
    this.height = h;
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.renderer.setSize(w, h, false);
    this.camera.aspect = w / h;
    this.camera.updateProjectionMatrix();
    if (this.fitted) this.fit();
    this.options.changed();
  }

  fit() {
    const radius = 0.5 * Math.hypot(...[0, 1, 2].map((k) => this.extent.upper[k] - this.extent.lower[k]));
    const half = (this.camera.fov * Math.PI) / 360, narrow = Math.atan(Math.tan(half) * Math.min(1, this.camera.aspect));
    const distance = (1.02 * radius) / Math.sin(narrow);
    this.camera.up.set(0, 0, 1);
    this.camera.position.copy(this.middle).add(new Vector3(0.55, -0.75, 0.42).normalize().multiplyScalar(distance));
    this.camera.near = distance / 1e4;
    this.camera.far = distance * 20;
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(this.middle);
    this.controls.update();
    this.fitted = true;
    this.options.changed();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).divideScalar(factor).add(this.controls.target);
    this.fitted = false;
    this.options.changed();
  }

  toScreen(x) {
    const v = new Vector3(...x).project(this.camera);
    return [((v.x + 1) * this.width) / 2, ((1 - v.y) * this.height) / 2];
  }
  /** Of a length across the line of sight at place x. */
  pixelsPerLength(x) {
    const forward = this.camera.getWorldDirection(new Vector3());
    const depth = new Vector3(...x).sub(this.camera.position).dot(forward);
    return this.height / (2 * Math.tan((this.camera.fov * Math.PI) / 360) * depth);
  }

  ballAt(place) {
    const x = [0, 0, 0], eye = this.camera.position;
    let best = -1, nearest = Infinity;
    for (let i = 0; i < this.replay.log.balls; ++i) {
      if (!this.replay.alive(i)) continue;
      this.replay.position(i, x);
      const [sx, sy] = this.toScreen(x), r = this.replay.radius(i) * this.pixelsPerLength(x);
      const depth = eye.distanceTo(new Vector3(...x));
      if (Math.hypot(sx - place[0], sy - place[1]) < Math.max(r, 8) && depth < nearest) [best, nearest] = [i, depth];
    }
    return best;
  }

  listen() {
    let down = null;
    const place = (event) => {
      const box = this.canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    this.canvas.addEventListener('pointerdown', (event) => {
      down = place(event);
      this.fitted = false;
    });
    this.canvas.addEventListener('pointerup', (event) => {
      const up = place(event);
      if (down && Math.hypot(up[0] - down[0], up[1] - down[1]) < 5) this.options.follow(this.ballAt(up));
      down = null;
    });
    this.canvas.addEventListener('dblclick', () => this.fit());
  }

  draw(marks) {
    if (!this.width) return;
    const {replay, options, colours} = this;
    this.renderer.setClearColor(colours.page.stage);
    if (this.frame) this.frame.material.color.set(colours.page.wall);
    for (const mesh of this.walls) {
      const d = drift(mesh.userData.wall, replay);
      mesh.position.set(...mesh.userData.at.toArray().map((x, k) => x + d[k]));
    }
    this.placeBalls();
    if (options.following >= 0) {
      const x = new Vector3(...replay.position(options.following));
      this.camera.position.add(x).sub(this.controls.target);
      this.controls.target.copy(x);
    }
    this.placeTrails();
    this.placeArrows();
    this.placeMarks(marks);
    this.renderer.render(this.world, this.camera);
  }

  placeBalls() {
    const {replay, balls, matrix, colour} = this, x = [0, 0, 0];
    for (let i = 0; i < replay.log.balls; ++i) {
      const r = replay.alive(i) ? Math.max(replay.radius(i), 0.004 * this.size) : 0;
      replay.position(i, x);
      matrix.makeScale(r, r, r).setPosition(x[0], x[1], x[2]);
      balls.setMatrixAt(i, matrix);
      balls.setColorAt(i, colour.set(this.colourOf(i)));
    }
    balls.instanceMatrix.needsUpdate = true;
    balls.instanceColor.needsUpdate = true;
    this.placeGhosts();
  }

  colourOf(i) {
    return i === this.options.following ? this.colours.page.accent : this.colours.of(i);
  }

  /** Periodic images around the cell, a sixth of a period far. */
  placeGhosts() {
    const {replay, options} = this;
    const wanted = options.images && replay.period[0] > 0;
    if (!wanted) {
      if (this.ghosts) this.ghosts.visible = false;
      return;
    }
    const places = [], {period, lower} = replay, x = [0, 0, 0];
    for (let i = 0; i < replay.log.balls; ++i) {
      if (!replay.alive(i)) continue;
      replay.position(i, x);
      for (let n = 0; n < 27; ++n) {
        const shift = [(n % 3) - 1, (Math.floor(n / 3) % 3) - 1, Math.floor(n / 9) - 1];
        if (n === 13) continue;
        const y = x.map((v, k) => v + shift[k] * period[k]);
        if (y.every((v, k) => v > lower[k] - period[k] / 6 && v < lower[k] + (7 / 6) * period[k])) places.push([y, replay.radius(i)]);
      }
    }
    if (!this.ghosts) {
      this.ghosts = new InstancedMesh(this.geometry, new MeshBasicMaterial({transparent: true, opacity: 0.1, color: this.colours.page.muted, depthWrite: false}), this.mostGhosts);
      this.ghosts.frustumCulled = false;
      this.world.add(this.ghosts);
    }
    this.ghosts.visible = true;
    this.ghosts.count = Math.min(places.length, this.mostGhosts);
    for (let n = 0; n < this.ghosts.count; ++n) {
      const [y, r] = places[n];
      this.ghosts.setMatrixAt(n, this.matrix.makeScale(r, r, r).setPosition(...y));
    }
    this.ghosts.instanceMatrix.needsUpdate = true;
  }

  placeTrails() {
    const {replay, options} = this, points = [], tints = [];
    if (options.trails) {
      const back = new Color(this.colours.page.stage), tint = new Color(), faded = new Color();
      const only = options.following >= 0 ? [options.following] : replay.log.balls <= 60 ? Array.from({length: replay.log.balls}, (_, i) => i) : [];
      for (const i of only) {
        if (!replay.alive(i)) continue;
        tint.set(this.colourOf(i));
        replay.trail(i, options.trailSpan, only.length === 1 ? 1000 : 60, (a, b, ageA, ageB) => {
          points.push(...a, ...b);
          for (const age of [ageA, ageB]) tints.push(...faded.copy(tint).lerp(back, age).toArray());
        });
      }
    }
    this.setLines(this.trails, points, tints);
  }

  placeArrows() {
    const {replay, options, colours} = this, list = [], x = [0, 0, 0], v = [0, 0, 0];
    if (options.arrows && replay.log.balls <= MOST_ARROWS) {
      const unit = (0.12 * this.size) / colours.fast;
      for (let i = 0; i < replay.log.balls; ++i) {
        if (!replay.alive(i)) continue;
        replay.position(i, x);
        replay.velocity(i, v);
        list.push([[...x], v.map((c) => c * unit)]);
      }
    }
    this.arrows.place(list, 0.0025 * this.size, colours.page.ink);
  }

  placeMarks(marks) {
    const list = [];
    let strongest = 0;
    for (const {contact, strength} of marks) {
      if (contact.kind === KIND.other || !(contact.impulse > 0)) continue;
      strongest = Math.max(strongest, strength);
      const length = contact.radius + this.size * (0.03 + 0.1 * Math.min(1, Math.sqrt(contact.impulse / this.options.largestImpulse)));
      list.push([contact.point, contact.normal.map((n) => n * length)]);
      if (contact.kind === KIND.balls) list.push([contact.point, contact.normal.map((n) => -n * length)]);
    }
    this.marks.place(list, 0.004 * this.size, this.colours.page.impulse, strongest);
  }
}

/** Arrows with bodies, so that they are seen at any size of the screen. */
class Arrows {
  constructor(world, inFront) {
    this.world = world;
    this.material = new MeshBasicMaterial({transparent: true, depthTest: !inFront});
    this.shaft = new CylinderGeometry(1, 1, 1, 8).translate(0, 0.5, 0);
    this.head = new ConeGeometry(1, 1, 12).translate(0, 0.5, 0);
    this.room = 0;
    this.inFront = inFront;
  }

  reserve(count) {
    if (count <= this.room) return;
    this.room = Math.max(count, 2 * this.room, 16);
    for (const mesh of this.meshes ?? []) this.world.remove(mesh);
    this.meshes = [this.shaft, this.head].map((geometry) => {
      const mesh = new InstancedMesh(geometry, this.material, this.room);
      mesh.frustumCulled = false;
      mesh.renderOrder = this.inFront ? 2 : 0;
      this.world.add(mesh);
      return mesh;
    });
  }

  /** `list`: [from, by]; `width` of the shafts. */
  place(list, width, colour, opacity = 1) {
    this.reserve(list.length);
    for (const mesh of this.meshes ?? []) mesh.count = list.length;
    if (list.length === 0) return;
    this.material.color.set(colour);
    this.material.opacity = opacity;
    const matrix = new Matrix4(), turn = new Quaternion(), along = new Vector3(), at = new Vector3(), scale = new Vector3(), up = new Vector3(0, 1, 0);
    list.forEach(([from, by], n) => {
      const length = Math.hypot(...by), head = Math.min(6 * width, 0.6 * length), shaft = length - head;
      along.set(...by).divideScalar(length || 1);
      turn.setFromUnitVectors(up, along);
      const thick = length > 0 ? width : 0;
      this.meshes[0].setMatrixAt(n, matrix.compose(at.set(...from), turn, scale.set(thick, shaft, thick)));
      this.meshes[1].setMatrixAt(n, matrix.compose(at.set(...from).addScaledVector(along, shaft), turn, scale.set(2.6 * thick, head, 2.6 * thick)));
    });
    for (const mesh of this.meshes) mesh.instanceMatrix.needsUpdate = true;
  }
}
