// SPDX-License-Identifier: BSD-2-Clause
// Any function of the model with inputs of one's own.

const startExplorer = () => {
  const select = choices('try-function', Object.keys(data.functions).map(name => [name, name]), () => choose());
  if (!select) return;
  let inputs = [];
  const evaluate = () => {
    const port = data.functions[select.value];
    const values = call(select.value, inputs.map(i => Number(i.value) || 0));
    let at = 0;
    byId('try-results').replaceChildren(...port.outputs.map(out => {
      const rows = [];
      for (let r = 0; r < out.rows; ++r) {
        const cells = [];
        for (let c = 0; c < out.cols; ++c) cells.push(element('td', { class: 'number' }, shown(values[at++], 6)));
        rows.push(element('tr', {}, ...cells));
      }
      return element('div', { class: 'wide', tabindex: '0', role: 'region', 'aria-label': `Result ${out.name}` },
        element('table', { class: 'matrix' }, element('caption', {}, `${out.name} [${out.unit}] ${out.doc}`), element('tbody', {}, ...rows)));
    }));
  };
  const choose = () => {
    inputs = [];
    const port = data.functions[select.value], start = (data.reference[select.value] || [[]])[0][0] || [];
    byId('try-inputs').replaceChildren(...port.inputs.map(input => {
      const field = element('fieldset', { class: 'numbers' }, element('legend', {}, `${input.name} [${input.unit}]`));
      for (let i = 0; i < input.size; ++i) {
        const box = element('input', { type: 'number', step: 'any', 'aria-label': `${input.name}[${i}]` });
        box.value = start[inputs.length] === undefined ? 0 : Number(start[inputs.length].toPrecision(6));
        box.addEventListener('input', evaluate);
        inputs.push(box);
        field.append(box);
      }
      return field;
    }));
    evaluate();
  };
  drawnInside(select.closest('details'), () => { if (!inputs.length) choose(); });
};

/// Curves of one function over one of its arguments, the others as in the reference state: the
/// picture of a model that has nothing to draw.
const startCurves = () => {
  const arguments_ = name => data.functions[name].inputs.flatMap(input => Array.from({ length: input.size },
    (_, i) => ({ name: input.size > 1 ? `${input.name}[${i}]` : input.name, unit: input.unit, range: input.ranges[i] })));
  const names = Object.keys(data.functions).filter(name => arguments_(name).some(a => a.range && a.range[1] > a.range[0]));
  const draw = () => {
    const name = which.value, at = Number(over.value), argument = arguments_(name)[at], x = [], all = [];
    const start = data.reference[name][0][0];
    for (let k = 0; k <= 200; ++k) {
      const inputs = [...start];
      inputs[at] = argument.range[0] + (argument.range[1] - argument.range[0]) * k / 200;
      x.push(inputs[at]);
      all.push(call(name, inputs));
    }
    let first = 0;
    show('curve-plots', ...data.functions[name].outputs.flatMap(out => {
      const size = out.rows * out.cols, from = first;
      first += size;
      const base = { x, xLabel: `${argument.name} [${argument.unit}]`, floor: 1e-13 };
      // Numbers of different units stand apart.
      const units = out.unit.split(', '), docs = out.doc.split(', ');
      if (size > 1 && units.length === size)
        return Array.from({ length: size }, (_, i) => plotted({ ...base, title: docs.length === size ? docs[i] : `${out.name}[${i}]`,
          yLabel: `[${units[i]}]`, series: [{ name: out.name, y: all.map(values => values[from + i]) }] }));
      return plotted({ ...base, title: out.name, yLabel: `${out.doc} [${out.unit}]`,
        note: size > 6 ? `The first six of ${size} numbers.` : '',
        series: Array.from({ length: Math.min(6, size) }, (_, i) => ({ name: size > 1 ? `${out.name}[${i}]` : out.name, key: size > 1, y: all.map(values => values[from + i]) })) });
    }));
  };
  const again = () => {
    over.replaceChildren();
    arguments_(which.value).forEach((a, i) => { if (a.range && a.range[1] > a.range[0]) over.append(element('option', { value: i }, a.name)); });
    draw();
  };
  const which = choices('curve-function', names.map(name => [name, name]), again), over = choices('curve-input', [], draw);
  if (which && names.length) again();
};
