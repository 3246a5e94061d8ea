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
