// SPDX-License-Identifier: BSD-2-Clause
// Where everything is, and what acts, in one state: all from the emitted functions.

const data = JSON.parse(byId('data').textContent);
const scene = data.scene;
const call = (name, inputs) => functions[name](inputs);
const picked = (state, indices) => indices.map(i => state[i]);

/// The sliders' values as the functions take them: a wrist is set by its palm's angles.
const stateOf = values => {
  const state = [...values];
  if (data.palm) {
    const bars = call(data.palm.inverse, picked(values, data.palm.at));
    data.palm.at.forEach((at, i) => { state[at] = bars[i]; });
  }
  return state;
};
/// And back.
const valuesOf = state => {
  const values = [...state];
  if (data.palm) {
    const angles = call(data.palm.forward, picked(state, data.palm.at));
    data.palm.at.forEach((at, i) => { values[at] = angles[i]; });
  }
  return values;
};

/// Poses of all frames of the scene.
const framesAt = state => {
  const frames = [];
  for (const carrier of scene.carriers) {
    const base = carrier.parent < 0 ? carrier.base : product(frames[carrier.parent], carrier.base);
    frames.push(base);
    if (!carrier.fn) continue;
    const poses = call(carrier.fn, picked(state, carrier.args)), rows = carrier.rows * 4;
    for (let k = 0; k < carrier.count; ++k)
      frames.push(product(base, poses.slice(k * rows, k * rows + 12)));
  }
  return frames;
};

/// Corner of a tendon on the inner side of a bend, or an arc over the pulley on its outer side.
const overPulley = (frames, at) => {
  const before = frames[at.in], after = frames[at.out];
  const axis = turned(after, at.axis), centre = moved(after, at.c || [0, 0, 0]);
  const from = turned(before, at.din), to = turned(after, at.dout);
  const side = scaled(cross(axis, from), -1), out = scaled(cross(axis, to), -1);
  const angle = Math.atan2(dot(axis, cross(from, to)), dot(from, to));
  if (at.r * angle <= 0) {
    const reach = Math.min(3, 1 / Math.max(0.05, 1 + Math.cos(angle)));
    return [add(centre, scaled(add(side, out), at.r * reach))];
  }
  const steps = Math.max(1, Math.ceil(Math.abs(angle) / 0.3)), points = [];
  for (let i = 0; i <= steps; ++i)
    points.push(add(centre, scaled(rotated(side, axis, angle * i / steps), at.r)));
  return points;
};

const pathOf = (frames, tendon) => {
  const points = [];
  for (const at of tendon.path)
    if (at.axis) points.push(...overPulley(frames, at));
    else points.push(moved(frames[at.f], at.p));
  return points;
};

const tipsAt = frames => scene.tips.map(tip => moved(frames[tip.frame], tip.p));

/// Rows of the Jacobian of a tip's position, in the drawing's frame; one column a coordinate of
/// tip.args.
const tipJacobian = (tip, state, frames) => {
  const n = tip.args.length, J = call(tip.fn, picked(state, tip.args));
  const rows = [[], [], []];
  for (let c = 0; c < n; ++c) {
    const column = turned(frames[tip.base], [J[c], J[n + c], J[2 * n + c]]);
    for (let k = 0; k < 3; ++k) rows[k].push(column[k]);
  }
  return rows;
};

/// sqrt(det(J J^T)), for fewer than three joints of J^T J: how much the tip moves for unit rates.
const manipulability = J => {
  const n = J[0].length, few = n < 3, size = few ? n : 3, G = [];
  for (let i = 0; i < size; ++i) {
    G.push([]);
    for (let j = 0; j < size; ++j) {
      let sum = 0;
      for (let k = 0; k < (few ? 3 : n); ++k) sum += few ? J[k][i] * J[k][j] : J[i][k] * J[j][k];
      G[i].push(sum);
    }
  }
  const det = size === 1 ? G[0][0] : size === 2 ? G[0][0] * G[1][1] - G[0][1] * G[1][0]
    : dot(G[0], cross(G[1], G[2]));
  return Math.sqrt(Math.max(0, det));
};

/// P = dh/dq as rows, one a tendon.
const couplingAt = state => {
  const flat = call(data.coupling, state), n = flat.length / scene.tendons.length, rows = [];
  for (let i = 0; i < scene.tendons.length; ++i) rows.push(flat.slice(i * n, i * n + n));
  return rows;
};

/// The smallest tensions, none below `least`, with P^T f = -load at the coordinates `held`; null
/// where there are none. f = least + max(0, P lambda), lambda by Newton's method on the dual.
const tensions = (P, held, load, least) => {
  const n = held.length, rows = P.map(row => held.map(c => row[c]));
  const wanted = held.map((c, k) => -load[k] - rows.reduce((sum, row) => sum + row[k] * least, 0));
  const size = Math.sqrt(wanted.reduce((sum, w) => sum + w * w, 0)) + 1e-12;
  let lambda = new Array(n).fill(0);
  const pull = at => rows.map(row => Math.max(0, row.reduce((s, p, k) => s + p * at[k], 0)));
  const missing = x => wanted.map((w, k) => w - rows.reduce((s, row, i) => s + row[k] * x[i], 0));
  const dual = at => pull(at).reduce((s, x) => s + x * x / 2, 0) -
    wanted.reduce((s, w, k) => s + w * at[k], 0);
  for (let step = 0; step < 60; ++step) {
    const x = pull(lambda), rest = missing(x);
    if (Math.sqrt(rest.reduce((s, r) => s + r * r, 0)) < 1e-9 * size)
      return x.map(value => value + least);
    const H = held.map((_, a) => held.map((__, b) => (a === b ? 1e-14 : 0) +
      rows.reduce((s, row, i) => s + (step === 0 || x[i] > 0 ? row[a] * row[b] : 0), 0)));
    const direction = solved(H, rest);
    if (!direction) return null;
    let length = 1;
    const before = dual(lambda), slope = rest.reduce((s, r, k) => s + r * direction[k], 0);
    const next = () => lambda.map((value, k) => value + length * direction[k]);
    while (length > 1e-9 && dual(next()) > before - 1e-4 * length * slope + 1e-16) length /= 2;
    lambda = next();
  }
  return null;
};

/// Compliance of a tip's position [m/N] with the motors held; null where joints are limp.
const complianceAt = (tip, state, frames, forces, stiffness) => {
  const m = scene.tendons.length;
  const K = call(data.stiffness, [...state, ...forces, ...new Array(m).fill(stiffness)]);
  const n = Math.round(Math.sqrt(K.length));
  const block = tip.args.map(r => tip.args.map(c => K[r * n + c]));
  const J = tipJacobian(tip, state, frames), C = [];
  for (let i = 0; i < 3; ++i) {
    const y = solved(block, J[i]);
    if (!y) return null;
    C.push(J.map(row => row.reduce((s, value, k) => s + value * y[k], 0)));
  }
  return C;
};
