// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/report/browser.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "identification/report/page.h"
#include "tests/reference/temporary_folder.h"

namespace sinew::report {
namespace {

namespace fs = std::filesystem;

// Reads the frames from outside: the pages themselves stay as they are, and allow no script.
constexpr const char* kProbe = R"(
<script>
addEventListener('load', () => {
  const lines = [];
  for (const frame of document.querySelectorAll('iframe')) {
    const page = frame.contentDocument, view = frame.contentWindow;
    const bottom = selector => {
      const found = page.querySelector(selector);
      return found ? Math.ceil(found.getBoundingClientRect().bottom) : 0;
    };
    const card = bottom('.cause'), next = bottom('.next');
    for (const folded of page.querySelectorAll('details')) folded.open = true;
    let widest = 0, smallest = 0, labels = 0, cut = 0;
    for (const element of page.querySelectorAll('body *')) {
      if (element.closest('.math') && !element.matches('.math')) continue;
      widest = Math.max(widest, Math.floor(element.getBoundingClientRect().right));
    }
    for (const text of page.querySelectorAll('svg text')) {
      const height = Math.round(text.getBoundingClientRect().height);
      smallest = smallest ? Math.min(smallest, height) : height;
      const box = text.getBoundingClientRect(), sheet = text.closest('svg').getBoundingClientRect();
      ++labels;
      if (box.left < sheet.left || box.right > sheet.right || box.top < sheet.top ||
          box.bottom > sheet.bottom) ++cut;
    }
    lines.push(['SEEN', frame.title, view.innerWidth, page.documentElement.scrollWidth, widest,
      view.performance.getEntriesByType('resource').length,
      page.querySelectorAll('svg').length, page.querySelectorAll('math').length, smallest,
      labels, cut, card, next].join(' '));
  }
  document.body.textContent = lines.join('\n') + '\n';
});
</script>
)";

std::vector<std::string> arguments_for(const fs::path& folder, const fs::path& page) {
  return {browser(),
          "--headless",
          "--no-sandbox",  // the pages are our own, and a container offers no sandbox
          "--disable-gpu",
          "--disable-quic",
          "--hide-scrollbars",
          "--no-first-run",
          "--disable-background-networking",
          "--disable-component-update",
          "--disable-sync",
          "--host-resolver-rules=MAP * ~NOTFOUND",
          "--window-size=1400,1000",
          "--user-data-dir=" + (folder / "profile").string(),
          "--enable-logging=stderr",
          "--dump-dom",
          "file://" + page.string()};
}

std::vector<Seen> seen_in(const std::string& output) {
  std::istringstream lines(output);
  std::vector<Seen> result;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("SEEN ");
    if (at == std::string::npos || line.find("lines.push") != std::string::npos) continue;
    std::istringstream fields(line.substr(at + 5));
    Seen s;
    if (fields >> s.name >> s.width >> s.content_width >> s.widest_element >> s.requests >>
        s.pictures >> s.equations >> s.smallest_text >> s.labels >> s.cut_labels >> s.first_card >>
        s.next_step)
      result.push_back(s);
  }
  return result;
}

}  // namespace

std::string browser() {
  const char* path = std::getenv("PATH");
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
      const fs::path program = fs::path(folder) / name;
      if (::access(program.c_str(), X_OK) == 0) return program.string();
    }
  }
  return "";
}

std::string browsed(const std::string& html) {
  const reference::TemporaryFolder folder;
  const fs::path page = folder.path() / "page.html";
  reference::write_text(page, html);
  std::string output;
  const int status = reference::run_program(arguments_for(folder.path(), page), output);
  if (status != 0)
    throw std::runtime_error("the browser ended with " + std::to_string(status) + ":\n" + output);
  return output;
}

std::vector<std::string> console_lines(const std::string& output) {
  std::istringstream lines(output);
  std::vector<std::string> found;
  for (std::string line; std::getline(lines, line);)
    if (line.find(":CONSOLE") != std::string::npos) found.push_back(line);
  return found;
}

Visit visit(const std::vector<Shown>& pages) {
  std::string html = "<!DOCTYPE html><html><head><meta charset=\"utf-8\"></head><body>";
  for (const Shown& page : pages)
    html += "<iframe title=\"" + page.name +
            "\" style=\"border:0;width:" + std::to_string(page.width) +
            "px;height:" + std::to_string(page.height) + "px\" srcdoc=\"" +
            diagnosis::escaped(page.html) + "\"></iframe>";
  const std::string output = browsed(html + kProbe + "</body></html>\n");
  Visit result{seen_in(output), console_lines(output)};
  if (result.seen.size() != pages.size())
    throw std::runtime_error("the browser answered for " + std::to_string(result.seen.size()) +
                             " of " + std::to_string(pages.size()) + " pages:\n" +
                             output.substr(0, 4000));
  return result;
}

std::vector<std::string> complaints_of_file(const std::string& html) {
  return console_lines(browsed(html));
}

}  // namespace sinew::report
