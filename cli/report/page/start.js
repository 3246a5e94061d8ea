// SPDX-License-Identifier: BSD-2-Clause
// What is seen first is drawn first; the rest follows when the browser has shown it.

const whenShown = action => requestAnimationFrame(() => setTimeout(action, 0));
if (data.run) startRun(); else startModel();
document.documentElement.dataset.drawn = Math.round(performance.now());
whenShown(() => {
  if (data.run) finishRun();
  else if (scene) { workspace(); along(); }
  startExplorer();
  document.documentElement.dataset.agreement = compareWithC();
  document.documentElement.dataset.ready = Math.round(performance.now());
});
window.sinew = { functions, data, drawing: () => drawing, compareWithC };
