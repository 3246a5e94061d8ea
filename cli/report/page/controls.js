// SPDX-License-Identifier: BSD-2-Clause
// One slider a joint, in the groups of the model.

class Sliders {
  constructor(host, values, changed) {
    this.values = [...values];
    this.inputs = [];
    const groups = new Map();
    data.coordinates.forEach((c, i) => {
      if (!groups.has(c.group)) {
        const field = element('fieldset', {}, element('legend', {}, c.group || 'Joints'));
        groups.set(c.group, field);
        host.append(field);
      }
      groups.get(c.group).append(this.row(c, i, changed));
    });
  }

  row(c, i, changed) {
    const id = 'joint-' + i;
    const input = element('input', { type: 'range', id, min: c.low, max: c.high, step: 'any' });
    const output = element('output', { for: id });
    input.step = (c.high - c.low) / 400;
    input.addEventListener('input', () => {
      this.values[i] = Number(input.value);
      this.tell(i);
      changed();
    });
    this.inputs.push({ input, output });
    this.set(i, this.values[i]);
    return element('div', { class: 'slider' }, element('label', { for: id }, c.label), input, output);
  }

  tell(i) {
    const text = told(this.values[i], data.coordinates[i].unit);
    const { input, output } = this.inputs[i];
    output.textContent = text;
    input.setAttribute('aria-valuetext', text);
  }

  set(i, value) {
    this.values[i] = value;
    this.inputs[i].input.value = value;
    this.tell(i);
  }
  setAll(values) { values.forEach((value, i) => this.set(i, value)); }
}

const choices = (id, entries, changed) => {
  const select = byId(id);
  if (!select) return null;
  entries.forEach(([value, text]) => select.append(element('option', { value }, text)));
  select.addEventListener('change', changed);
  return select;
};
const pressed = (id, action) => {
  const button = byId(id);
  if (button) button.addEventListener('click', () => action(button));
};
const toggled = (id, action) => pressed(id, button => {
  const on = button.getAttribute('aria-pressed') !== 'true';
  button.setAttribute('aria-pressed', String(on));
  action(on);
});
const views = drawing => {
  pressed('view-first', () => drawing.look(data.view.yaw, data.view.pitch));
  pressed('view-front', () => drawing.look(0, 0));
  pressed('view-side', () => drawing.look(-Math.PI / 2, 0));
  pressed('view-top', () => drawing.look(-Math.PI / 2, Math.PI / 2));
  pressed('nearer', () => drawing.magnify(1.25));
  pressed('farther', () => drawing.magnify(0.8));
};
