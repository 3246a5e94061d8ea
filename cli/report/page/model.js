// SPDX-License-Identifier: BSD-2-Clause
// The page of a model: what acts in the pose that the sliders set, and how it changes along a joint.

const tipLabel = tip => tip.name === 'tip' ? 'Tip' : scene.tips.length > 1 ? `Tip of ${tip.name}` : tip.name;
const tipName = tip => scene.tips.length === 1 ? 'the tip' : `the tip of ${tip.name}`;
const reference = data.coordinates.map(c => c.reference);
let drawing = null, sliders = null, now = null;

const slider = id => { const input = byId(id); return input ? Number(input.value) : NaN; };

/// What the bodies' weight asks of the coordinates that are held.
const weightAt = state => {
  if (data.gravity) return call(data.gravity, state);
  // Fingers on a palm that tilts: gravity in each one's base frame, and the torques that hold it at rest.
  const { gravity, torques, coordinates } = data.weighed, still = Array(coordinates).fill(0);
  const held = call(torques, [...state.slice(0, coordinates), ...still, ...still, ...call(gravity, [...state, 0, 0, -9.81])]);
  return data.held.map((_, i) => i < coordinates ? held[i] : 0);
};

/// State, frames, P, tensions and compliances at the sliders' values.
const computed = values => {
  const state = stateOf(values), frames = framesAt(state);
  const result = { values, state, frames, tips: tipsAt(frames), forces: null, compliance: null };
  if (!data.coupling) return result;
  result.least = slider('least');
  const P = couplingAt(state), weight = byId('weight');
  const load = weight && weight.checked ? weightAt(state) : data.held.map(() => 0);
  result.forces = tensions(P, data.held, load, result.least);
  if (data.free.length && result.forces)
    result.rest = data.free.map(c => -P.reduce((s, row, i) => s + row[c] * result.forces[i], 0));
  if (!data.stiffness || !result.forces) return result;
  const stiffness = slider('stiffness') * 1000;
  result.compliance = scene.tips.map(tip => tip.fn && tip.args.length
    ? complianceAt(tip, state, frames, result.forces, stiffness) : null);
  return result;
};

const facts = list => list.map(([name, text]) => element('div', {}, element('dt', {}, name), element('dd', {}, text)));

const readout = r => {
  const list = [];
  if (scene.tips.length === 1)
    list.push([`${tipLabel(scene.tips[0])} at x, y, z`, r.tips[0].map(v => fixed(1000 * v, 1)).join(', ') + ' mm']);
  else scene.tips.forEach((tip, i) => list.push([tipLabel(tip), r.tips[i].map(v => fixed(1000 * v, 1)).join(', ') + ' mm']));
  if (data.palm) list.push(['Bar angles q71, q73', picked(r.state, data.palm.at).map(v => fixed(v, 3)).join(', ') + ' rad']);
  if (data.coupling) {
    list.push([data.held.length ? 'Tensions that hold it' : 'Tensions', r.forces ? `${shown(smallest(r.forces))} to ${shown(largest(r.forces))} N`
      : 'none do: tendons only pull']);
    if (r.rest) list.push(['What the wrist’s drive has to hold', r.rest.map(v => shown(v)).join(', ') + ' N m']);
  }
  if (scene.tips.length === 1 && scene.tips[0].fn && !data.coordinates.some(c => c.unit === 'm')) {
    const w = manipulability(tipJacobian(scene.tips[0], r.state, r.frames));
    const power = Math.min(3, scene.tips[0].args.length);
    list.push(['Manipulability', `${shown(w * 1000 ** power)} mm${power > 1 ? '²³'[power - 2] : ''} per rad${power > 1 ? '²³'[power - 2] : ''}`]);
  }
  const C = r.compliance && r.compliance.find(Boolean);
  if (C && scene.tips.length === 1) {
    const { values } = eigen3(C);
    list.push(['One newton moves the tip by', `${shown(1000 * Math.max(0, values[0]))} to ${shown(1000 * values[2])} mm`]);
  }
  byId('readout').replaceChildren(...facts(list));
};

/// So large that the reference pose's ellipse is easy to see, rounded to 1, 2 or 5.
const chooseMagnification = r => {
  const C = r.compliance && r.compliance.filter(Boolean);
  drawing.magnified = 1;
  if (!C || !C.length) return;
  const most = largest(C.map(c => eigen3(c).values[2]));
  const wanted = 0.1 * Math.min(drawing.width, drawing.height) / drawing.scale / most;
  const power = 10 ** Math.floor(Math.log10(wanted));
  drawing.magnified = [5, 2, 1].map(f => f * power).find(f => f <= wanted) || power;
  const told = byId('magnified');
  if (told) told.textContent = `Ellipse: where one newton in any direction moves the tip, drawn ${shown(drawing.magnified)} times as large.`;
};

const refresh = () => {
  now = computed(sliders.values);
  drawing.ellipse = byId('show-ellipse') && byId('show-ellipse').getAttribute('aria-pressed') === 'true'
    ? now.compliance : null;
  drawing.slackBelow = 0;
  drawing.mostForce = now.forces ? Math.max(1.6 * now.least, largest(now.forces)) : 1;
  drawing.draw(now.state, now.forces);
  const legend = byId('force-most');
  if (legend) legend.textContent = now.forces ? shown(drawing.mostForce) + ' N' : '–';
  readout(now);
  clearTimeout(refresh.later);
  if (rest.done) refresh.later = setTimeout(along, 60);
};

/// Plots along the joint chosen, the others as they are.
const along = () => {
  const select = byId('along');
  if (!select) return;
  const c = Number(select.value), coordinate = data.coordinates[c];
  const f = friendly(coordinate.unit), x = [], rows = [];
  for (let k = 0; k <= 60; ++k) {
    const values = [...sliders.values];
    values[c] = coordinate.low + (coordinate.high - coordinate.low) * k / 60;
    x.push(values[c] * f.scale);
    rows.push(values);
  }
  const base = { x, xLabel: `${coordinate.label} [${f.name.trim() || '1'}]`, mark: sliders.values[c] * f.scale };
  if (data.coupling) alongTendons(base, rows, c);
  const tips = scene.tips.filter(tip => tip.fn && tip.args.includes(c));
  if (tips.length) alongTip(base, rows, tips[0]);
  else for (const id of ['manipulability-plots', 'stiffness-plots'])
    show(id, element('p', { class: 'absent' }, `No fingertip’s position depends on ${coordinate.label} by its own joints.`));
};

const alongTendons = (base, rows, c) => {
  const states = rows.map(stateOf), P = states.map(couplingAt);
  const lengths = states.map(s => call(data.lengths, s)), start = call(data.lengths, stateOf(reference));
  const moving = scene.tendons.map((_, i) => i).filter(i =>
    P.some(p => Math.abs(p[i][c]) > 1e-9) || largest(lengths.map(h => h[i])) - smallest(lengths.map(h => h[i])) > 1e-9);
  const name = i => scene.tendons[i].name;
  const many = moving.length > 12;
  const key = many ? `${moving.length} tendons, one line each.` : '';
  const one = { colour: 'var(--after)', dash: '' };
  const series = y => moving.map(i => ({ name: name(i), y: y(i), look: many ? one : undefined, key: true }));
  const figures = [
    { ...base, title: 'Tendon lengths', yLabel: 'longer than in the reference pose [mm]', note: key, floor: 1e-9,
      series: series(i => lengths.map(h => 1000 * (h[i] - start[i]))) },
    { ...base, title: 'Moment arms', yLabel: `∂h/∂${data.coordinates[c].column || data.coordinates[c].label} [mm/rad]`,
      note: key, floor: 1e-9, series: series(i => P.map(p => 1000 * p[i][c])) }].map(plotted);
  if (many) figures.forEach(figure => figure.querySelector('.key').remove());
  show('tendon-plots', ...figures);
};

const alongTip = (base, rows, tip) => {
  const all = rows.map(values => { const state = stateOf(values); return { state, frames: framesAt(state), values }; });
  const J = all.map(a => tipJacobian(tip, a.state, a.frames));
  const sizes = J.map(rows => eigen3(rows.map(a => rows.map(b => a.reduce((s, v, k) => s + v * b[k], 0)))).values
    .map(v => 1000 * Math.sqrt(Math.max(0, v))).reverse());
  const few = Math.min(3, tip.args.length);
  const names = ['fastest direction', few === 3 ? 'middle direction' : 'slowest direction', 'slowest direction'].slice(0, few);
  show('manipulability-plots',
    plotted({ ...base, title: `Speed of ${tipName(tip)}`, yLabel: `for joint rates of 1 rad/s${data.coordinates.some(c => c.unit === 'm') ? ' or 1 m/s' : ''} [mm/s]`, zero: true, floor: 1e-9,
      series: names.map((name, k) => ({ name, key: true, y: sizes.map(s => s[k]) })) }),
    plotted({ ...base, title: 'Manipulability', yLabel: `product of these speeds [mm${few > 1 ? '²³'[few - 2] : ''}/s${few > 1 ? '²³'[few - 2] : ''}]`, zero: true, floor: 1e-9,
      series: [{ name: 'manipulability', y: sizes.map(s => s.slice(0, few).reduce((a, b) => a * b, 1)) }] }));
  if (!data.stiffness) return;
  const index = scene.tips.indexOf(tip);
  const soft = all.map(a => { const C = computed(a.values).compliance; return C && C[index] ? eigen3(C[index]).values : null; });
  const value = (s, k) => s && s[k] > 1e-15 ? 1e-3 / s[k] : NaN;
  // In a stretched pose one direction is as stiff as the links: drawn to scale it would hide the rest.
  const stiffest = soft.map(s => value(s, 0)).filter(Number.isFinite).sort((a, b) => a - b);
  const limit = few === 3 && stiffest.length ? 4 * stiffest[stiffest.length >> 1] : Infinity;
  const cut = v => v > limit ? NaN : v;
  show('stiffness-plots',
    plotted({ ...base, title: `Stiffness at ${tipName(tip)}`, yLabel: 'motors held [N/mm]', zero: true,
      series: (few === 3 ? [2, 1, 0] : [2]).map((k, i) => ({ key: true, name: ['softest direction', 'middle direction', 'stiffest direction'][i], y: soft.map(s => cut(value(s, k))) })),
      note: stiffest[stiffest.length - 1] > limit ? `Left out above ${shown(limit)} N/mm, where links that are nearly stretched out carry the load.` : '' }),
    poses(all.filter((_, k) => k % 15 === 0), tip, index));
};

/// Five poses from the joint's one end to the other, each with its ellipse, as the drawing looks.
const poses = (all, tip, index) => {
  const old = { frames: drawing.frames, middle: drawing.middle, scale: drawing.scale, zoom: drawing.view.zoom, w: drawing.width, h: drawing.height };
  const svg = svgElement('svg', { viewBox: '0 0 460 270', role: 'img', class: 'plot' });
  const title = svgElement('title');
  title.textContent = 'The same mechanism in five poses with an ellipse at its tip';
  svg.append(title);
  const own = scene.bones.filter(b => !b.kind);
  const bonesOf = a => own.map(b => [moved(a.frames[b.a], b.p), moved(a.frames[b.b], b.q)]);
  [drawing.width, drawing.height, drawing.view.zoom] = [460, 270, 0.8];
  drawing.fit(all.flatMap(a => bonesOf(a).flat()));
  for (const [k, a] of all.entries()) {
    for (const bone of bonesOf(a)) svg.append(svgElement('path', { class: 'thin', style: `opacity:${0.35 + 0.15 * k}`, d: drawing.line(bone.map(p => drawing.projected(p))) }));
    const C = computed(a.values).compliance, at = drawing.projected(moved(a.frames[tip.frame], tip.p));
    if (C && C[index]) svg.append(svgElement('path', { class: 'ellipse', d: drawing.ellipsePath(at, C[index]) }));
  }
  Object.assign(drawing, { frames: old.frames, middle: old.middle, scale: old.scale, width: old.w, height: old.h });
  drawing.view.zoom = old.zoom;
  return element('figure', {}, element('h4', {}, 'Stiffness ellipses in five poses'),
    element('p', { class: 'label' }, `where 1 N moves the tip, ${shown(drawing.magnified)} times as large; seen as above`), svg);
};

/// Tips over the whole range of all joints.
const workspace = () => {
  const clouds = scene.tips.map(() => []), n = data.coordinates.length;
  const count = Math.max(300, Math.round(2400 / Math.max(1, scene.tips.length)));
  for (let k = 0; k < count; ++k) {
    const share = halton(k, n);
    const values = data.coordinates.map((c, i) => c.low + (c.high - c.low) * share[i]);
    tipsAt(framesAt(stateOf(values))).forEach((p, i) => clouds[i].push(p));
  }
  drawing.clouds = clouds.flat();
  const planes = [['x', 'z', 0, 2], ['x', 'y', 0, 1], ['y', 'z', 1, 2]];
  show('workspace-plots', ...planes.map(([a, b, i, j]) => plotted({
    title: `Seen along ${'xyz'[3 - i - j]}`, xLabel: `${a} [mm]`, yLabel: `${b} [mm]`, square: true,
    series: scene.tips.map((tip, k) => ({ name: tip.name, key: scene.tips.length > 1, points: true,
      x: clouds[k].map(p => 1000 * p[i]), y: clouds[k].map(p => 1000 * p[j]) })) })));
};

/// The page against the C: results in the reference states, by the largest entry of each.
const compareWithC = () => {
  let most = 0, count = 0;
  for (const [name, states] of Object.entries(data.reference || {})) {
    ++count;
    for (const [inputs, outputs] of states) {
      const got = call(name, inputs), size = Math.max(1e-300, largest(outputs.map(Math.abs)));
      outputs.forEach((value, i) => { most = Math.max(most, Math.abs(got[i] - value) / size); });
    }
  }
  const told = byId('agreement');
  if (told && count) told.textContent = `The page computes with the operations of the C: in two states of each of the ${count} functions that it holds the results ${most === 0 ? 'are the same, bit by bit' : `differ by at most ${shown(most, 2)} of the largest entry, which is rounding`}.`;
  return most;
};

const startModel = () => {
  drawing = new Drawing(byId('drawing'));
  sliders = new Sliders(byId('sliders'), reference, refresh);
  // So that the finger stays in sight when it is stretched out.
  const stretched = data.coordinates.map(c => Math.min(c.high, Math.max(c.low, 0)));
  drawing.fitted = [reference, stretched].map(values => framesAt(stateOf(values)));
  drawing.frames = drawing.fitted[0];
  drawing.refit();
  chooseMagnification(computed(reference));
  refresh();
  views(drawing);
  pressed('pose-reference', () => { sliders.setAll(reference); refresh(); });
  pressed('pose-zero', () => { sliders.setAll(stretched); refresh(); });
  pressed('pose-next', () => {
    startModel.k = (startModel.k || 0) + 1;
    const share = halton(startModel.k, data.coordinates.length);
    sliders.setAll(data.coordinates.map((c, i) => c.low + (c.high - c.low) * share[i]));
    refresh();
  });
  toggled('show-reach', on => { drawing.cloud = on ? drawing.clouds : null; drawing.redraw(); });
  toggled('show-ellipse', refresh);
  for (const id of ['least', 'stiffness', 'weight']) {
    const input = byId(id);
    if (input) input.addEventListener('input', () => { tellForces(); refresh(); });
  }
  tellForces();
  drawing.tell('');
  drawing.refitWhenResized();
};

/// What stands below the first screen.
const finishModel = () => {
  workspace();
  choices('along', data.coordinates.map((c, i) => [i, (c.group ? c.group + ', ' : '') + c.label]), along);
  if (byId('along')) byId('along').value = data.along;
  along();
};

const tellForces = () => {
  for (const [id, unit] of [['least', ' N'], ['stiffness', ' N/mm']])
    if (byId(id)) {
      const text = shown(slider(id)) + unit;
      byId(id + '-told').textContent = text;
      byId(id).setAttribute('aria-valuetext', text);
    }
};
