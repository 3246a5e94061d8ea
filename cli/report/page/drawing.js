// SPDX-License-Identifier: BSD-2-Clause
// The mechanism in three dimensions: parallel projection, nearer things over farther ones.

class Drawing {
  constructor(host) {
    this.svg = host;
    this.scene = svgElement('g');
    this.over = svgElement('g');
    this.cloudPath = svgElement('path', { class: 'cloud reach' });
    this.svg.append(this.cloudPath, this.scene, this.over);
    this.pool = [];
    this.cloud = null;
    this.ellipse = null;
    this.view = { ...data.view };
    this.listen();
  }

  /// Screen axes; the third points at who looks.
  axes() {
    const { yaw, pitch } = this.view, c = Math.cos(pitch), s = Math.sin(pitch);
    return [[-Math.sin(yaw), Math.cos(yaw), 0],
      [-s * Math.cos(yaw), -s * Math.sin(yaw), c], [c * Math.cos(yaw), c * Math.sin(yaw), s]];
  }

  /// Chooses scale and middle so that these points fill the drawing.
  fit(points) {
    const [right, up] = this.axes();
    const xs = points.map(p => dot(p, right)), ys = points.map(p => dot(p, up));
    const low = [Math.min(...xs), Math.min(...ys)], high = [Math.max(...xs), Math.max(...ys)];
    this.scale = 0.86 * Math.min(this.width / Math.max(high[0] - low[0], 1e-6),
      this.height / Math.max(high[1] - low[1], 1e-6));
    this.middle = add(scaled(right, (low[0] + high[0]) / 2), scaled(up, (low[1] + high[1]) / 2));
  }

  measure() {
    const box = this.svg.getBoundingClientRect();
    this.width = Math.max(200, box.width);
    this.height = Math.max(200, box.height);
    this.svg.setAttribute('viewBox', `0 0 ${this.width} ${this.height}`);
  }

  projected(p) {
    const d = minus(p, this.middle), [right, up, toward] = this.now;
    const zoom = this.scale * this.view.zoom;
    return [this.width / 2 + zoom * dot(d, right), this.height / 2 - zoom * dot(d, up), dot(d, toward)];
  }

  draw(state, forces) {
    this.state = state;
    this.forces = forces;
    this.frames = framesAt(state);
    this.redraw();
  }

  redraw() {
    this.now = this.axes();
    const parts = [];
    this.addBodies(parts);
    this.addBones(parts);
    this.addTendons(parts);
    parts.sort((a, b) => a.depth - b.depth);
    while (this.pool.length < parts.length) {
      const path = svgElement('path');
      this.pool.push(path);
      this.scene.append(path);
    }
    this.pool.forEach((path, i) => {
      const part = parts[i];
      path.setAttribute('d', part ? part.d : '');
      path.setAttribute('class', part ? part.kind : '');
      path.setAttribute('style', part ? part.style || '' : '');
      path.dataset.name = part ? part.name || '' : '';
    });
    this.drawOver();
  }

  line(points) {
    return points.map((p, i) => (i ? 'L' : 'M') + p[0].toFixed(1) + ' ' + p[1].toFixed(1)).join('');
  }

  addBodies(parts) {
    const light = unit([0.35, 0.5, 0.8]);
    for (const body of scene.bodies) {
      const T = this.frames[body.frame], centre = moved(T, body.centre);
      const axes = [0, 1, 2].map(k => turned(T, [body.axes[k], body.axes[3 + k], body.axes[6 + k]]));
      for (let k = 0; k < 3; ++k)
        for (const sign of [-1, 1]) {
          const normal = scaled(axes[k], sign);
          const facing = dot(normal, this.now[2]);
          if (facing <= 0) continue;
          const [u, v] = [axes[(k + 1) % 3], axes[(k + 2) % 3]];
          const [hu, hv] = [body.half[(k + 1) % 3], body.half[(k + 2) % 3]];
          const middle = add(centre, scaled(normal, body.half[k]));
          const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([i, j]) =>
            this.projected(add(middle, add(scaled(u, i * hu), scaled(v, j * hv)))));
          const seen = [dot(normal, this.now[0]), dot(normal, this.now[1]), facing];
          parts.push({ depth: dot(minus(centre, this.middle), this.now[2]) + 1e-4 * facing,
            d: this.line(corners) + 'Z', kind: 'face',
            style: `--lit:${Math.round(100 * Math.max(0, dot(seen, light)))}%`,
            name: `${body.name}: ${told(body.mass * 1000, 'g')}` });
        }
    }
  }

  addBones(parts) {
    for (const bone of scene.bones) {
      const a = this.projected(moved(this.frames[bone.a], bone.p));
      const b = this.projected(moved(this.frames[bone.b], bone.q));
      parts.push({ depth: (a[2] + b[2]) / 2, d: this.line([a, b]), kind: bone.kind || 'bone',
        name: bone.name });
    }
    for (const joint of scene.joints) {
      const T = this.frames[joint.frame], axis = scaled(turned(T, joint.axis), joint.length / 2);
      const at = moved(T, [0, 0, 0]);
      const a = this.projected(minus(at, axis)), b = this.projected(add(at, axis));
      parts.push({ depth: (a[2] + b[2]) / 2 + 1e-5, d: this.line([a, b]), kind: 'joint',
        name: 'joint ' + joint.name });
    }
  }

  addTendons(parts) {
    const most = this.forces ? Math.max(1e-9, this.mostForce || Math.max(...this.forces)) : 1;
    scene.tendons.forEach((tendon, i) => {
      const force = this.forces ? this.forces[i] : NaN;
      const share = Math.max(0, Math.min(1, force / most));
      const slack = this.forces && !(force > this.slackBelow);
      const style = !this.forces || slack ? ''
        : `stroke:color-mix(in oklch,var(--much) ${Math.round(100 * share)}%,var(--little));` +
          `stroke-width:${(1 + 1.8 * share).toFixed(2)}`;
      const name = `tendon ${tendon.name}` + (this.forces ? `: ${shown(force)} N` : '');
      const points = pathOf(this.frames, tendon).map(p => this.projected(p));
      for (let k = 1; k < points.length; ++k)
        parts.push({ depth: (points[k - 1][2] + points[k][2]) / 2 + 2e-4, name, style,
          d: this.line([points[k - 1], points[k]]), kind: slack ? 'tendon slack' : 'tendon' });
    });
  }

  drawOver() {
    this.over.replaceChildren();
    this.cloudPath.setAttribute('d', this.cloud ? this.cloud.map(p => {
      const q = this.projected(p);
      return `M${q[0].toFixed(1)} ${q[1].toFixed(1)}h0`;
    }).join('') : '');
    scene.tips.forEach((tip, i) => {
      const p = this.projected(moved(this.frames[tip.frame], tip.p));
      this.over.append(svgElement('circle', { cx: p[0].toFixed(1), cy: p[1].toFixed(1), r: 4, class: 'tip' }));
      const C = this.ellipse && this.ellipse[i];
      if (C) this.over.append(svgElement('path', { class: 'ellipse', d: this.ellipsePath(p, C) }));
    });
    this.drawScale();
    this.drawTriad();
  }

  /// Outline of the ellipsoid of a symmetric matrix: where a unit force moves the tip, magnified.
  ellipsePath(at, C) {
    const [right, up] = this.now, zoom = this.scale * this.view.zoom * this.magnified;
    const S = [right, up].map(u => C.map(row => dot(row, u)));
    const a = dot(S[0], right), b = dot(S[0], up), c = dot(S[1], up);
    // Of C e over all unit directions e the outline is that of the square of C.
    const squared = [right, up].map(u => {
      const v = C.map(row => dot(row, u));
      return [right, up].map(w => dot(v, C.map(row => dot(row, w))));
    });
    const [xx, xy, yy] = [squared[0][0], squared[0][1], squared[1][1]];
    const mean = (xx + yy) / 2, part = Math.hypot((xx - yy) / 2, xy);
    const angle = 0.5 * Math.atan2(2 * xy, xx - yy);
    const l1 = Math.sqrt(Math.max(0, mean + part)), l2 = Math.sqrt(Math.max(0, mean - part));
    let d = '';
    for (let k = 0; k <= 48; ++k) {
      const t = 2 * Math.PI * k / 48;
      const x = l1 * Math.cos(t), y = l2 * Math.sin(t);
      const px = x * Math.cos(angle) - y * Math.sin(angle), py = x * Math.sin(angle) + y * Math.cos(angle);
      d += (k ? 'L' : 'M') + (at[0] + zoom * px).toFixed(1) + ' ' + (at[1] - zoom * py).toFixed(1);
    }
    return Number.isFinite(a + b + c) ? d + 'Z' : '';
  }

  drawScale() {
    const zoom = this.scale * this.view.zoom, wanted = 0.18 * this.width / zoom;
    const power = 10 ** Math.floor(Math.log10(wanted));
    const length = [5, 2, 1].map(f => f * power).find(l => l <= wanted) || power;
    const x = this.width - 16, y = this.height - 16;
    this.over.append(svgElement('path', { class: 'scale',
      d: `M${x - length * zoom} ${y - 4}v4H${x}v-4` }));
    const label = svgElement('text', { x, y: y - 10, class: 'label', 'text-anchor': 'end' });
    label.textContent = told(length, 'm').replace(/\.0 /, ' ');
    this.over.append(label);
  }

  drawTriad() {
    const at = [34, this.height - 34];
    ['x', 'y', 'z'].forEach((name, k) => {
      const e = [0, 0, 0];
      e[k] = 1;
      const x = 24 * dot(e, this.now[0]), y = -24 * dot(e, this.now[1]);
      this.over.append(svgElement('path', { class: 'triad', d: `M${at[0]} ${at[1]}l${x.toFixed(1)} ${y.toFixed(1)}` }));
      const label = svgElement('text', { class: 'label', 'text-anchor': 'middle',
        x: (at[0] + 1.35 * x).toFixed(1), y: (at[1] + 1.35 * y + 4).toFixed(1) });
      label.textContent = name;
      this.over.append(label);
    });
  }

  turn(yaw, pitch) {
    this.view.yaw += yaw;
    this.view.pitch = Math.max(-1.57, Math.min(1.57, this.view.pitch + pitch));
    this.redraw();
  }
  magnify(factor) {
    this.view.zoom = Math.max(0.3, Math.min(12, this.view.zoom * factor));
    this.redraw();
  }
  look(yaw, pitch) {
    this.view = { yaw, pitch, zoom: 1 };
    this.refit();
  }
  refit() {
    this.measure();
    const points = (this.fitted || [this.frames]).flatMap(frames => this.extent(frames));
    this.fit(points.length ? points : [[0, 0, 0], [0.1, 0.1, 0.1]]);
    this.redraw();
  }

  refitWhenResized() {
    this.refit();
    new ResizeObserver(() => {
      const box = this.svg.getBoundingClientRect();
      if (Math.abs(box.width - this.width) > 1 || Math.abs(box.height - this.height) > 1) this.refit();
    }).observe(this.svg);
  }

  /// Points that enclose everything drawn.
  extent(frames) {
    const points = [];
    for (const body of scene.bodies) {
      const T = frames[body.frame];
      for (const s of [[1, 1, 1], [1, 1, -1], [1, -1, 1], [1, -1, -1], [-1, 1, 1], [-1, 1, -1], [-1, -1, 1], [-1, -1, -1]]) {
        const c = [0, 1, 2].map(k => s[0] * body.axes[3 * k] * body.half[0] +
          s[1] * body.axes[3 * k + 1] * body.half[1] + s[2] * body.axes[3 * k + 2] * body.half[2]);
        points.push(moved(T, add(body.centre, c)));
      }
    }
    for (const bone of scene.bones)
      points.push(moved(frames[bone.a], bone.p), moved(frames[bone.b], bone.q));
    for (const tendon of scene.tendons) points.push(...pathOf(frames, tendon));
    return points;
  }

  listen() {
    const held = new Map();
    let gap = 0;
    this.svg.addEventListener('pointerdown', event => {
      held.set(event.pointerId, [event.clientX, event.clientY]);
      try { this.svg.setPointerCapture(event.pointerId); } catch (_) { /* a pointer that is gone */ }
    });
    this.svg.addEventListener('pointermove', event => {
      const last = held.get(event.pointerId);
      if (!last) return this.tell(event.target.dataset && event.target.dataset.name);
      held.set(event.pointerId, [event.clientX, event.clientY]);
      const all = [...held.values()];
      if (all.length === 2) {
        const now = Math.hypot(all[0][0] - all[1][0], all[0][1] - all[1][1]);
        if (gap > 0) this.magnify(now / gap);
        gap = now;
      } else this.turn(-0.01 * (event.clientX - last[0]), 0.01 * (event.clientY - last[1]));
    });
    for (const name of ['pointerup', 'pointercancel'])
      this.svg.addEventListener(name, event => { held.delete(event.pointerId); gap = 0; });
    this.svg.addEventListener('wheel', event => {
      if (!event.ctrlKey) return;  // scrolling the page stays scrolling
      event.preventDefault();
      this.magnify(Math.exp(-0.003 * event.deltaY));
    }, { passive: false });
    this.svg.addEventListener('keydown', event => {
      const keys = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
      if (keys[event.key]) this.turn(...keys[event.key]);
      else if (event.key === '+' || event.key === '=') this.magnify(1.15);
      else if (event.key === '-') this.magnify(1 / 1.15);
      else if (event.key === '0' || event.key === 'Home') this.look(data.view.yaw, data.view.pitch);
      else return;
      event.preventDefault();
    });
  }

  tell(name) {
    if (this.told === name) return;
    this.told = name;
    byId('pointed').textContent = name || 'Turn: drag, or arrow keys. Zoom: + and −, two fingers, Ctrl and wheel.';
  }
}
