// SPDX-License-Identifier: BSD-2-Clause
// What is seen first is drawn first; the rest follows when the browser has shown it.

const rest = () => {
  if (rest.done) return;
  rest.done = true;
  if (data.run) finishRun();
  else if (scene) finishModel();
  startExplorer();
  compareWithC();
  document.documentElement.dataset.ready = Math.round(performance.now());
};
if (data.run) startRun(); else if (scene) startModel(); else startCurves();
document.documentElement.dataset.drawn = Math.round(performance.now());
addEventListener('DOMContentLoaded', () => requestAnimationFrame(() => setTimeout(rest, 0)));
// Printing shows what is folded.
const unfold = () => { for (const action of whenUnfolded) action(); };
addEventListener('beforeprint', () => { rest(); unfold(); });
window.sinew = { functions, data, compareWithC, rest, unfold };
