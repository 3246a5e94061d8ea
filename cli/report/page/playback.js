// SPDX-License-Identifier: BSD-2-Clause
// The page of a run: played back in the drawing, with a mark at the same time in every plot.

const run = data.run;
const numbersIn = text => {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  return new Float32Array(bytes.buffer);
};
let marks = [], playing = null;

const channel = (k, what) => {
  const start = (3 * k + what) * run.instants;
  return Array.from(run.values.subarray(start, start + run.instants));
};
const instant = time => {
  let low = 0, high = run.instants - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (run.time[middle] <= time) low = middle; else high = middle;
  }
  return time - run.time[low] <= run.time[high] - time ? low : high;
};
const valueAt = (column, i) => run.values[3 * column * run.instants + i];

/// The state of an instant; coordinates that the run does not log stay in the reference pose.
const stateInstant = i => {
  const reference = stateOf(data.coordinates.map(c => c.reference));
  return run.coordinates.map((c, k) => c < 0 ? reference[k] : valueAt(c, i));
};

const showTime = time => {
  const i = instant(time);
  byId('time').value = time;
  const text = fixed(time, 3) + ' s';
  byId('time-told').textContent = text;
  byId('time').setAttribute('aria-valuetext', text);
  if (drawing) {
    const state = stateInstant(i);
    drawing.draw(state, run.forces.length ? run.forces.map(c => valueAt(c, i)) : null);
    byId('readout').replaceChildren(...facts(runFacts(i, state)));
  }
  for (const { path, x } of marks)
    path.setAttribute('d', path.getAttribute('d').replace(/^M[^ ]*/, 'M' + x(time).toFixed(1)));
};

const runFacts = (i, state) => {
  const list = scene.tips.slice(0, 6).map((tip, k) => [`${tipLabel(tip)} at x, y, z`,
    tipsAt(drawing.frames)[k].map(v => fixed(1000 * v, 1)).join(', ') + ' mm']);
  if (run.forces.length) {
    const all = run.forces.map(c => valueAt(c, i));
    list.push(['Tendon forces', `${shown(smallest(all))} to ${shown(largest(all))} N`]);
    const slack = all.filter(f => f <= run.slackBelow).length;
    list.push(['Slack tendons', slack ? String(slack) : 'none']);
  }
  return list;
};

const play = button => {
  if (playing) {
    cancelAnimationFrame(playing);
    playing = null;
    button.textContent = 'Play';
    return;
  }
  const end = run.time[run.instants - 1];
  let start = performance.now(), from = Number(byId('time').value);
  if (from >= end - 1e-9) from = run.time[0];
  button.textContent = 'Pause';
  const frame = now => {
    const time = from + (now - start) / 1000 * Number(byId('speed').value);
    showTime(Math.min(time, end));
    if (time >= end) { playing = null; button.textContent = 'Play'; return; }
    playing = requestAnimationFrame(frame);
  };
  playing = requestAnimationFrame(frame);
};

const plotOfRun = (title, unit, columns, noted) => plotted({
  title, yLabel: `[${unit}]`, xLabel: 'time [s]', x: run.time, mark: Number(byId('time').value), note: noted,
  floor: unit === 'N' ? 1e-9 : 1e-12,
  series: columns.map(([name, k]) => ({ name, key: true, y: channel(k, 0), low: channel(k, 1), high: channel(k, 2) })) });

const withMark = figure => {
  const path = figure.querySelector('.mark');
  if (path) marks.push({ path, x: figure.x });
  return figure;
};

/// Plots of a group when it is opened: a hand has hundreds of channels.
const groupsOfRun = () => {
  for (const group of run.groups) {
    const folded = byId(group.id);
    if (!folded) continue;
    const host = folded.querySelector('.figures');
    drawnInside(folded, () => {
      if (host.childElementCount) return;
      for (let k = 0; k < group.columns.length; k += 6)
        host.append(withMark(plotOfRun(group.columns.length > 6 ? `${group.title} ${k + 1} to ${Math.min(k + 6, group.columns.length)}` : group.title,
          group.unit, group.columns.slice(k, k + 6))));
    });
  }
};

/// When each tendon was slack, a line a tendon.
const slackOfRun = () => {
  if (!byId('slack-plot') || !run.slack.length) return;
  const names = [...new Set(run.slack.map(s => s[0]))], end = run.time[run.instants - 1];
  const series = names.map((name, k) => {
    const x = [], y = [];
    for (const [which, from, to] of run.slack)
      if (which === name) { x.push(from, to, NaN); y.push(k + 1, k + 1, NaN); }
    return { name, key: true, x, y };
  });
  show('slack-plot', withMark(plotted({ title: 'When tendons are slack', yLabel: 'one line a tendon', xLabel: 'time [s]',
    x: [run.time[0], end], series: [...series, { name: 'whole run', look: { colour: 'transparent', dash: '' }, x: [run.time[0], end], y: [0.5, names.length + 0.5] }],
    mark: Number(byId('time').value) })));
};

const startRun = () => {
  run.values = numbersIn(run.packed);
  run.time = Array.from(numbersIn(run.times));
  // run.html#0.6 begins at 0.6 s.
  const asked = Number(location.hash.slice(1));
  const first = asked > run.time[0] && asked <= run.time[run.instants - 1] ? asked : run.time[0];
  if (scene) {
    drawing = new Drawing(byId('drawing'));
    drawing.magnified = 1;
    drawing.slackBelow = run.slackBelow;
    drawing.mostForce = run.forces.length ? 1.4 * Math.max(1, ...run.forces.map(k => largest(channel(k, 2)))) : 1;
    drawing.frames = framesAt(stateOf(data.coordinates.map(c => c.reference)));
    const legend = byId('force-most');
    if (legend) legend.textContent = shown(drawing.mostForce) + ' N';
    // So that the whole run stays in sight.
    drawing.fitted = [0, 1, 2, 3, 4, 5, 6, 7, 8].map(k =>
      framesAt(stateInstant(Math.round(k * (run.instants - 1) / 8))));
    drawing.refit();
    showTime(first);
    views(drawing);
    drawing.tell('');
    drawing.refitWhenResized();
  } else showTime(first);
  const time = byId('time');
  time.addEventListener('input', () => showTime(Number(time.value)));
  pressed('play', play);
};

const finishRun = () => {
  if (run.energy.length) show('energy-plots', ...run.energy.map(plot => withMark(plotted({ ...plot, xLabel: 'time [s]', x: run.energyTime, mark: Number(byId('time').value) }))));
  slackOfRun();
  groupsOfRun();
};
