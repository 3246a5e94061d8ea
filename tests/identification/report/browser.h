// SPDX-License-Identifier: GPL-3.0-or-later
// Pages in a browser without a window: what it complains about, fetches and lays out.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sinew::report {

/// The browser's program, empty where none is installed.
std::string browser();

/// A page shown in a frame.
struct Shown {
  std::string name, html;
  int width = 0, height = 0;  ///< CSS pixels
};

/// What the browser made of it. All <details> are opened before anything is measured.
struct Seen {
  std::string name;
  int width = 0;           ///< of the view
  int content_width = 0;   ///< more than `width`: the page scrolls sideways
  int widest_element = 0;  ///< right edge of the element that reaches furthest
  int requests = 0;        ///< resources that were asked for
  int pictures = 0, equations = 0;
  int smallest_text = 0;  ///< height of the lowest line of text in a picture, px; 0: no pictures
  int labels = 0;         ///< lines of text in pictures
  int cut_labels = 0;     ///< those that reach beyond their picture
  int first_card = 0;     ///< lower edge of the first verdict card
  int next_step = 0;      ///< lower edge of "what to do next"
};

struct Visit {
  std::vector<Seen> seen;
  std::vector<std::string> complaints;  ///< lines of the console
};

/// Shows all pages at once. Throws std::runtime_error where the browser does not answer.
Visit visit(const std::vector<Shown>& pages);

/// What the browser prints of a page opened as a file of its own: the document after it was loaded,
/// and the console's lines. Throws std::runtime_error where it does not answer.
std::string browsed(const std::string& html);

/// The console's lines of that.
std::vector<std::string> console_lines(const std::string& output);

/// Console lines of a page opened as a file of its own.
std::vector<std::string> complaints_of_file(const std::string& html);

}  // namespace sinew::report
