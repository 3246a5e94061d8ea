// SPDX-License-Identifier: BSD-2-Clause
// Numbers and elements as the page shows them.

/// `digits` significant digits, a real minus sign, no exponent where it can be helped.
const shown = (value, digits = 3) => {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  let text = size >= 1e5 || size < 1e-4
    ? value.toExponential(digits - 1).replace('e+', 'e')
    : String(Number(value.toPrecision(digits)));
  const exponent = text.match(/^(.*)e(-?\d+)$/);
  if (exponent) text = Number(exponent[1]) + '·10' + raised(exponent[2]);
  return text.replace('-', '−');
};
const raised = text => [...text].map(c => '⁰¹²³⁴⁵⁶⁷⁸⁹'['0123456789'.indexOf(c)] || '⁻').join('');
const fixed = (value, decimals) => value.toFixed(decimals).replace(/^-(0(\.0+)?)$/, '$1').replace('-', '−');

/// What people read instead of SI: degrees, millimetres.
const friendly = unit => unit === 'rad' ? { scale: 180 / Math.PI, name: '°', decimals: 0 }
  : unit === 'm' ? { scale: 1000, name: ' mm', decimals: 1 }
  : { scale: 1, name: unit && unit !== '1' ? ' ' + unit : '', decimals: 3 };
const told = (value, unit) => {
  const f = friendly(unit);
  return fixed(value * f.scale, f.decimals) + f.name;
};

const byId = id => document.getElementById(id);
const element = (name, attributes = {}, ...children) => {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
};
const svgElement = (name, attributes = {}) => {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
};
