// SPDX-License-Identifier: BSD-2-Clause
// Lines over one axis, as SVG in the page's colours; the key stands above, clear of the axes.

const roles = ['after', 'before', 'extra-2', 'extra-1', 'extra-3', 'measured'];
const dashes = ['', '7 4', '2 3', '9 3 2 3'];
const lookOf = k => ({ colour: `var(--${roles[k % roles.length]})`, dash: dashes[Math.floor(k / roles.length) % dashes.length] });

const niceStep = (span, most) => {
  const raw = span / most, power = 10 ** Math.floor(Math.log10(raw));
  return [1, 2, 5, 10].map(f => f * power).find(s => s >= raw * 0.999);
};
const ticksOf = (low, high, most) => {
  const step = niceStep(high - low, most), ticks = [];
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
    ticks.push({ at: k * step, text: decimals > 5 || Math.abs(k * step) >= 1e6 ? shown(k * step) : fixed(k * step, decimals) });
  return ticks;
};

/// `plot`: {title, xLabel, yLabel, x, series: [{name, y, low, high, points}], mark, zero, square}.
/// Values are drawn as given. A series whose whole range is rounding is told so.
const plotted = plot => {
  const W = plot.square ? 340 : 460, H = plot.square ? 310 : 270, left = 66, right = 14, top = 14, bottom = 40;
  const svg = svgElement('svg', { viewBox: `0 0 ${W} ${H}`, role: 'img', class: 'plot' });
  const title = svgElement('title');
  title.textContent = plot.alternative || `${plot.title}: ${plot.yLabel} over ${plot.xLabel}`;
  svg.append(title);
  const series = plot.series.filter(s => s.y.some(Number.isFinite));
  if (!series.length) return element('p', { class: 'absent' }, 'Nothing to draw.');
  const everyX = plot.series.flatMap(s => s.x || plot.x).filter(Number.isFinite);
  const everyY = series.flatMap(s => [...s.y, ...(s.low || []), ...(s.high || [])]).filter(Number.isFinite);
  let x0 = smallest(everyX), x1 = largest(everyX), y0 = smallest(everyY), y1 = largest(everyY);
  const size = Math.max(Math.abs(y0), Math.abs(y1));
  const flat = y1 - y0 <= 1e-9 * size || size < (plot.floor || 0);
  const why = size === 0 ? 'Everything here is 0.' : size < (plot.floor || 0)
    ? 'What is seen here is rounding noise.' : flat ? 'Constant: the curve differs from this value by rounding alone.' : '';
  if (flat) [y0, y1] = [Math.min(0, 1.2 * y0) , Math.max(0, 1.2 * y1)];
  if (y1 === y0) { y0 -= 1; y1 += 1; }
  if (plot.zero) { y0 = Math.min(0, y0); y1 = Math.max(0, y1); }
  if (x1 === x0) { x0 -= 1; x1 += 1; }
  const air = 0.05 * (y1 - y0);
  y0 -= air; y1 += air;
  if (plot.square) {
    const gap = 0.04 * (x1 - x0);
    x0 -= gap; x1 += gap;
    const perPixel = Math.max((x1 - x0) / (W - left - right), (y1 - y0) / (H - top - bottom));
    const mx = (x0 + x1) / 2, my = (y0 + y1) / 2;
    [x0, x1] = [mx - perPixel * (W - left - right) / 2, mx + perPixel * (W - left - right) / 2];
    [y0, y1] = [my - perPixel * (H - top - bottom) / 2, my + perPixel * (H - top - bottom) / 2];
  }
  const X = x => left + (x - x0) / (x1 - x0) * (W - left - right);
  const Y = y => H - bottom - (y - y0) / (y1 - y0) * (H - top - bottom);
  const text = (x, y, content, anchor) => {
    const made = svgElement('text', { x: x.toFixed(1), y: y.toFixed(1), 'text-anchor': anchor, class: 'label' });
    made.textContent = content;
    svg.append(made);
  };
  for (const tick of ticksOf(y0, y1, 5)) {
    svg.append(svgElement('path', { class: tick.at === 0 ? 'axis' : 'grid', d: `M${left} ${Y(tick.at).toFixed(1)}H${W - right}` }));
    text(left - 7, Y(tick.at) + 4, tick.text, 'end');
  }
  for (const tick of ticksOf(x0, x1, plot.square ? 4 : 6)) {
    svg.append(svgElement('path', { class: 'axis', d: `M${X(tick.at).toFixed(1)} ${H - bottom}v5` }));
    text(X(tick.at), H - bottom + 18, tick.text, 'middle');
  }
  svg.append(svgElement('path', { class: 'axis', d: `M${left} ${top}V${H - bottom}H${W - right}` }));
  text((left + W - right) / 2, H - 5, plot.xLabel, 'middle');
  const line = (xs, ys) => {
    let d = '', pen = false;
    for (let i = 0; i < ys.length; ++i) {
      if (!Number.isFinite(ys[i])) { pen = false; continue; }
      d += (pen ? 'L' : 'M') + X(xs[i]).toFixed(1) + ' ' + Y(ys[i]).toFixed(1);
      pen = true;
    }
    return d;
  };
  series.forEach((s, k) => {
    const look = s.look || lookOf(k), xs = s.x || plot.x;
    if (s.low) svg.append(svgElement('path', { class: 'band', style: `fill:${look.colour}`,
      d: line(xs, s.high) + line([...xs].reverse(), [...s.low].reverse()).replace('M', 'L') + 'Z' }));
    if (s.points) svg.append(svgElement('path', { class: 'cloud', style: `stroke:${look.colour}`,
      d: s.y.map((y, i) => Number.isFinite(y) ? `M${X(xs[i]).toFixed(1)} ${Y(y).toFixed(1)}h0` : '').join('') }));
    else svg.append(svgElement('path', { class: 'curve', style: `stroke:${look.colour}`,
      'stroke-dasharray': look.dash, d: line(xs, s.y) }));
  });
  if (plot.mark !== undefined && plot.mark >= x0 && plot.mark <= x1)
    svg.append(svgElement('path', { class: 'mark', d: `M${X(plot.mark).toFixed(1)} ${top}V${H - bottom}` }));
  const figure = element('figure', {}, element('h4', {}, plot.title), element('p', { class: 'label' }, plot.yLabel));
  if (series.length > 1 || series[0].key) {
    const key = element('ul', { class: 'key' });
    series.forEach((s, k) => {
      const look = s.look || lookOf(k);
      const sample = svgElement('svg', { class: 'sample', viewBox: '0 0 28 6', 'aria-hidden': 'true' });
      sample.append(svgElement('path', { d: s.points ? 'M14 3h0' : 'M0 3H28', class: s.points ? 'cloud' : 'curve', style: `stroke:${look.colour}`, 'stroke-dasharray': s.points ? '' : look.dash }));
      key.append(element('li', {}, sample, s.name));
    });
    figure.append(key);
  }
  figure.append(svg);
  if (why || plot.note) figure.append(element('p', { class: 'small soft' }, [plot.note, why].filter(Boolean).join(' ')));
  figure.x = X;
  return figure;
};
const smallest = all => all.reduce((a, b) => Math.min(a, b), Infinity);
const largest = all => all.reduce((a, b) => Math.max(a, b), -Infinity);
const show = (id, ...figures) => { const host = byId(id); if (host) host.replaceChildren(...figures); };

/// What is drawn in folded parts of the page once they are open.
const whenUnfolded = [];
const drawnInside = (folded, action) => {
  const when = () => { if (folded.open) action(); };
  folded.addEventListener('toggle', when);
  whenUnfolded.push(when);
  when();
};
