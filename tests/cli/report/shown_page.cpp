// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/report/shown_page.h"

#include <stdexcept>

#include "identification/report/page.h"
#include "tests/identification/report/browser.h"

namespace sinew::report {
namespace {

constexpr const char* kProbe = R"(
<script>
addEventListener('load', () => {
  const wanted = JSON.parse(document.getElementById('wanted').textContent);
  const result = {};
  const nameOf = element => (element.getAttribute('aria-label') || element.textContent.trim() ||
    [...(element.labels || [])].map(label => label.textContent.trim()).join(' ')).trim();
  for (const frame of document.querySelectorAll('iframe')) {
    const page = frame.contentDocument, view = frame.contentWindow;
    const one = selector => page.querySelector(selector);
    const all = selector => [...page.querySelectorAll(selector)];
    const seen = result[frame.title] = { started: Boolean(view.sinew) };
    if (!view.sinew) continue;
    view.sinew.rest();
    seen.title = page.title;
    seen.headline = one('h1').textContent;
    seen.width = view.innerWidth;
    seen.sections = all('main section').map(section => section.id);
    const drawn = () => one('#drawing') ? one('#drawing').innerHTML : '';
    const count = kind => all('#drawing path').filter(p => p.classList.contains(kind) && p.getAttribute('d')).length;
    for (const kind of ['face', 'bone', 'frame', 'joint', 'tendon', 'slack']) seen[kind] = count(kind);
    seen.ellipses = all('#drawing .ellipse').length;
    seen.sliders = all('#sliders input').length;
    if (one('#drawing')) {
      const still = drawn();
      const move = (type, x, y) => one('#drawing').dispatchEvent(new view.PointerEvent(type,
        { pointerId: 7, clientX: x, clientY: y, bubbles: true }));
      move('pointerdown', 100, 100); move('pointermove', 160, 120); move('pointerup', 160, 120);
      seen.pointerMoves = drawn() !== still;
      const turned = drawn();
      move('pointermove', 220, 150);
      seen.restsWhenLetGo = drawn() === turned;
      one('#drawing').dispatchEvent(new view.KeyboardEvent('keydown', { key: 'ArrowLeft', bubbles: true }));
      seen.keysMove = drawn() !== turned;
      one('#drawing').dispatchEvent(new view.KeyboardEvent('keydown', { key: 'Home', bubbles: true }));
      seen.homeReturns = drawn() === still;
    }
    const input = one('#sliders input') || one('#time');
    if (input && one('#drawing')) {
      const before = drawn(), facts = one('#readout').textContent;
      input.value = Number(input.min) + 0.8 * (Number(input.max) - Number(input.min));
      input.dispatchEvent(new view.Event('input', { bubbles: true }));
      seen.sliderMoves = drawn() !== before;
      seen.readoutFollows = one('#readout').textContent !== facts;
    }
    const weight = one('#weight');
    if (weight) {
      const facts = one('#readout').textContent;
      weight.click();
      seen.weightFollows = one('#readout').textContent !== facts;
      weight.click();
      seen.weightReturns = one('#readout').textContent === facts;
    }
    for (const folded of all('details')) folded.open = true;
    view.sinew.unfold();
    seen.boxes = all('#try-inputs input').length;
    if (seen.boxes) {
      const before = one('#try-results').textContent, box = one('#try-inputs input');
      box.value = Number(box.value) + 0.3;
      box.dispatchEvent(new view.Event('input', { bubbles: true }));
      seen.explorerFollows = one('#try-results').textContent !== before;
    }
    for (const button of all('button')) if (button.id !== 'play') button.click();
    seen.plots = all('svg.plot').length;
    seen.equations = all('math').length;
    seen.unnamed = all('button, input, select, summary, [tabindex], svg[role]').filter(element =>
      !nameOf(element) && !element.querySelector('title')).map(element => element.outerHTML.slice(0, 120));
    seen.unfocusable = all('button, input, select, summary').filter(e => e.tabIndex < 0).length;
    seen.doubled = all('[id]').map(e => e.id).filter((id, i, ids) => ids.indexOf(id) !== i);
    seen.contentWidth = page.documentElement.scrollWidth;
    let widest = 0, name = '';
    for (const element of all('body *')) {
      if (element.closest('.math, .wide') && !element.matches('.math, .wide')) continue;
      const right = Math.floor(element.getBoundingClientRect().right);
      if (right > widest) { widest = right; name = element.outerHTML.slice(0, 120); }
    }
    seen.widest = widest;
    seen.widestName = name;
    seen.cutLabels = all('svg.plot text').filter(text => {
      const box = text.getBoundingClientRect(), sheet = text.closest('svg').getBoundingClientRect();
      return box.width > 0 && (box.left < sheet.left - 1 || box.right > sheet.right + 1 || box.bottom > sheet.bottom + 1);
    }).map(text => text.textContent);
    seen.minus = all('svg.plot text').some(text => text.textContent.includes('−'));
    seen.hyphens = all('svg.plot text').filter(text => /^-\d/.test(text.textContent)).length;
    seen.requests = view.performance.getEntriesByType('resource').length;
    seen.agreement = view.sinew.compareWithC();
    const ink = view.getComputedStyle(page.body);
    seen.paper = ink.backgroundColor;
    seen.ink = ink.color;
    seen.firstDrawing = one('#drawing') ? Math.round(one('#drawing').getBoundingClientRect().top + view.scrollY) : 0;
    seen.results = {};
    for (const [name, states] of Object.entries(wanted[frame.title] || {}))
      seen.results[name] = states.map(inputs => view.sinew.functions[name](inputs));
  }
  document.body.textContent = 'SEEN ' + btoa(unescape(encodeURIComponent(JSON.stringify(result)))) + ' END';
});
</script>
)";

std::string from_base64(const std::string& text) {
  static const std::string letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    const std::size_t value = letters.find(c);
    if (value == std::string::npos) break;
    bits = bits << 6 | static_cast<unsigned>(value);
    if ((count += 6) < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255u);
  }
  return bytes;
}

}  // namespace

ShownPages show(const std::vector<ShownPage>& pages, const nlohmann::json& calls) {
  std::string html = "<!DOCTYPE html><html><head><meta charset=\"utf-8\"></head><body>";
  for (const ShownPage& page : pages)
    html += "<iframe title=\"" + page.name +
            "\" style=\"border:0;height:900px;width:" + std::to_string(page.width) +
            "px;color-scheme:" + (page.dark ? "dark" : "light") + "\" srcdoc=\"" +
            diagnosis::escaped(page.html) + "\"></iframe>";
  html += "<script type=\"application/json\" id=\"wanted\">" +
          (calls.is_null() ? std::string("{}") : calls.dump()) + "</script>";
  const std::string output = browsed(html + kProbe + "</body></html>\n");
  const std::size_t at = output.rfind("SEEN "), end = output.rfind(" END");
  const std::string json = at == std::string::npos || end == std::string::npos || end < at
                               ? ""
                               : from_base64(output.substr(at + 5, end - at - 5));
  ShownPages shown{nlohmann::json::parse(json, nullptr, false), console_lines(output)};
  if (!shown.seen.is_object() || shown.seen.size() != pages.size())
    throw std::runtime_error("the browser did not answer for all pages:\n" +
                             output.substr(0, 4000));
  return shown;
}

}  // namespace sinew::report
