// The scene of a system, from its parts as data: built once, moved by the rows as they come.
import { THREE } from "nicegui-scene";
import { rig } from "/live/live.js";

const UP = new THREE.Vector3(0, 1, 0);
let frame = null;
const number = (entry) => (entry !== null && typeof entry === "object" ? frame.v[entry.signal] : entry);
const vector = (entries) => new THREE.Vector3(...entries.map(number));

function geometry(part) {
  const size = part.size.map(number);
  if (part.shape === "box") return new THREE.BoxGeometry(...size);
  if (part.shape === "cylinder") return new THREE.CylinderGeometry(size[0], size[0], size[1], 28, 1);
  return new THREE.PlaneGeometry(size[0], size[1] ?? size[0]);
}

function material(part) {
  return new THREE.MeshPhongMaterial({ color: part.color, opacity: part.opacity, transparent: part.opacity < 1, side: THREE.DoubleSide });
}

function shaft(part) {
  const group = new THREE.Group(), paint = material(part), jet = part.shape === "jet";
  const body = new THREE.Mesh(jet ? new THREE.ConeGeometry(0.04, 1, 12) : new THREE.CylinderGeometry(0.012, 0.012, 1, 10), paint);
  body.position.y = 0.5;
  group.add(body);
  if (!jet) {
    group.head = new THREE.Mesh(new THREE.ConeGeometry(0.035, 0.1, 12), paint);
    group.add(group.head);
  }
  group.body = body;
  return group;
}

function build(part) {
  const group = new THREE.Group();
  if (part.shape === "arrow" || part.shape === "jet") group.add((group.shaft = shaft(part)));
  else if (part.shape === "patches") {
    const from = vector(part.at), to = vector(part.to), step = to.clone().sub(from).divideScalar(part.count);
    const plane = geometry(part);
    group.patches = [...Array(part.count).keys()].map((k) => {
      const patch = new THREE.Mesh(plane, material(part));
      patch.position.copy(from).addScaledVector(step, k + 0.5);
      group.add(patch);
      return patch;
    });
    group.half = step.length() * 0.5;
  } else {
    const mesh = new THREE.Mesh(geometry(part), material(part));
    if (part.shape === "plane") mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), vector(part.along).normalize());
    group.add(mesh);
    if (part.shape !== "plane") mesh.add(new THREE.LineSegments(new THREE.EdgesGeometry(mesh.geometry, 10), new THREE.LineBasicMaterial({ color: "#1f2328", transparent: true, opacity: 0.5 })));
  }
  return group;
}

function turn(group, part) {
  const q = part.attitude.map(number);
  if (q.length === 4) group.quaternion.set(q[1], q[2], q[3], q[0]);
  else if (q.length === 9) group.quaternion.setFromRotationMatrix(new THREE.Matrix4().set(q[0], q[1], q[2], 0, q[3], q[4], q[5], 0, q[6], q[7], q[8], 0, 0, 0, 0, 1));
  if (part.turn !== null) group.quaternion.multiply(new THREE.Quaternion().setFromAxisAngle(UP, number(part.turn)));
}

function point(group, part) {
  const way = vector(part.along).multiplyScalar(number(part.value) * part.scale), length = way.length(), { body, head } = group.shaft;
  group.shaft.visible = length > 1e-3;
  if (!group.shaft.visible) return;
  group.shaft.quaternion.setFromUnitVectors(UP, way.normalize());
  body.scale.set(1, length, 1);
  body.position.y = length / 2;
  if (head) head.position.y = length;
}

async function begin() {
  const place = document.querySelector(".scene .nicegui-scene");
  const element = place && window.getElement?.(place);
  if (!element?.camera || !element.controls || rig.about === null || !rig.frames.length) return setTimeout(begin, 100);
  const root = new THREE.Group(), parts = rig.about.scene.parts, groups = {}, all = [];
  root.rotation.x = Math.PI; // north, east, down as north, west, up
  element.scene.add(root);
  frame = rig.frames.at(-1);
  for (const part of parts) {
    const group = build(part);
    (groups[part.on] ?? root).add(group);
    if (part.name) groups[part.name] = group;
    all.push([part, group]);
  }
  const eye = new THREE.Vector3(), spot = new THREE.Vector3(), before = new THREE.Vector3();
  let first = true;
  const wipe = (part, group) => {
    if (part.when !== null && !(number(part.when) > 0)) return;
    groups[part.under].getWorldPosition(spot);
    root.worldToLocal(spot);
    for (const patch of group.patches) {
      const way = new THREE.Vector3().subVectors(patch.position, spot);
      const along = new THREE.Vector3().subVectors(vector(part.to), vector(part.at)).normalize();
      if (Math.abs(way.dot(along)) <= group.half * 1.5) patch.visible = false;
    }
  };
  const move = (rows) => {
    frame = rows;
    for (const [part, group] of all) {
      if (part.shape !== "patches" && part.at.length === 3) group.position.copy(vector(part.at));
      if (part.shape === "arrow" || part.shape === "jet") point(group, part);
      else turn(group, part);
    }
    root.updateMatrixWorld(true);
    for (const [part, group] of all) {
      if (part.shape === "patches") wipe(part, group);
      if (part.follow) {
        group.getWorldPosition(eye);
        if (first) {
          element.controls.target.copy(eye);
          element.camera.position.copy(eye).add(new THREE.Vector3(0.7, -1.3, 0.5));
        } else {
          element.controls.target.add(eye).sub(before);
          element.camera.position.add(eye).sub(before);
        }
        before.copy(eye);
        first = false;
      }
    }
  };
  rig.frames.forEach(move);
  let waiting = null, drawn = 0, moved = true;
  element.controls.addEventListener("change", () => (moved = true));
  new ResizeObserver(() => (moved = true)).observe(place);
  rig.listeners.push({
    rows: (rows) => {
      if (waiting === null) requestAnimationFrame(() => {
        move(waiting);
        waiting = null;
        moved = true;
      });
      waiting = rows;
    },
    begins: () => {
      all.forEach(([, group]) => group.patches?.forEach((patch) => (patch.visible = true)));
      moved = true;
    },
  });
  const render = element.renderer.render.bind(element.renderer);
  element.renderer.render = (...what) => {
    if (!moved) return;
    moved = false;
    render(...what);
    rig.scenes = ++drawn;
  };
  rig.scene = { groups, all };
}
begin();
