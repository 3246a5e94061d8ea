// SPDX-License-Identifier: GPL-3.0-or-later
// A sound description, one edit that spoils it, and the place and words of the message expected.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace malformed {

enum class Format { toml, csv, urdf };

/// `from` in the sound text is replaced by `to`; the message must stand at the first place of `at`
/// in the spoilt text ("": no line, "^": line 1, column 1) and contain `phrase`.
struct Case {
  std::string_view from;
  std::string_view to;
  std::string_view at;
  std::string_view phrase;
};

extern const std::string_view sound_toml;
extern const std::string_view sound_csv;
extern const std::string_view sound_urdf;

const std::vector<Case>& toml_cases();
const std::vector<Case>& csv_cases();
const std::vector<Case>& urdf_cases();

/// All mistakes found in a description spoilt in one format; empty if it was read.
std::vector<std::string> mistakes(Format format, std::string_view text);

/// The sound text of a format with one edit; the edited part must be there.
std::string spoilt(std::string_view sound, const Case& edit);

/// "file:line:column: " of the first place of `at` in a text, as in Case; columns are counted in
/// UTF-8 characters.
std::string expected_place(std::string_view text, std::string_view at);

/// One of the messages must stand at the case's place and contain its phrase; all must say what was
/// expected.
void check_messages(const Case& each, std::string_view text,
                    const std::vector<std::string>& messages);

}  // namespace malformed
