// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/hand/read_hand.h"

#include <fmt/format.h>

#include <charconv>
#include <map>

#include "symbolic/files/read_text.h"
#include "symbolic/files/toml_reader.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/rotation.h"
#include "symbolic/parts/part.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

/// "1-4, 9" as 0, 1, 2, 3, 8; nothing where the text is no such list.
std::optional<std::vector<int>> channel_list(const std::string& text) {
  std::vector<int> channels;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto skip = [&] {
    while (at != end && *at == ' ') ++at;
  };
  const auto number = [&](int& value) {
    skip();
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || value < 1 || value > 1000) return false;
    at = next;
    skip();
    return true;
  };
  while (true) {
    int low = 0, high = 0;
    if (!number(low)) return std::nullopt;
    high = low;
    if (at != end && *at == '-' && !(++at, number(high))) return std::nullopt;
    if (high < low) return std::nullopt;
    for (int channel = low; channel <= high; ++channel) channels.push_back(channel - 1);
    if (at == end) return channels;
    if (*at++ != ',') return std::nullopt;
  }
}

class HandReader {
 public:
  HandReader(TomlTable root, fs::path folder)
      : root_(std::move(root)), folder_(std::move(folder)) {}

  HandDescription read() {
    if (auto header = root_.table("hand", true)) read_header(*header);
    for (TomlTable& table : root_.tables("finger")) read_finger(table);
    if (!root_.has("finger"))
      root_.report("finger", "the hand has no finger", "expected at least one [[finger]]");
    if (auto table = root_.table("four_bar", false)) read_linkage(*table);
    root_.finish();
    return std::move(result_);
  }

 private:
  void read_header(TomlTable& header) {
    result_.hand.name = header.model_name("name").value_or("");
    result_.hand.description = header.text("description", false).value_or("");
    if (const auto part = part_named(header, "wrist"))
      take<WristParameters>(header, "wrist", *part, result_.hand.wrist);
    header.finish();
  }

  void read_finger(TomlTable& table) {
    HandFinger finger;
    if (const auto path = model_path(table, "model", "mechanism.toml", "mechanism")) {
      finger.mechanism = read_mechanism(*path);
      table.set_path("finger." + finger.mechanism.name);
    }
    if (auto base = table.table("base", true)) finger.base = pose(*base);
    finger.on_coupler =
        table.word("carried_by", {"palm", "four_bar"}, "palm").value_or("palm") == "four_bar";
    if (finger.on_coupler && !root_.has("four_bar"))
      table.report("carried_by", table.path() + " rides on a four-bar that the hand has not",
                   "expected a section [four_bar], or \"palm\"");
    finger.channels = channels(table, finger.mechanism.tendons.size());
    table.finish();
    result_.hand.fingers.push_back(std::move(finger));
  }

  void read_linkage(TomlTable& table) {
    if (const auto part = part_named(table, "model")) {
      result_.hand.four_bar_name = part->name;
      take<FourBarParameters>(table, "model", *part, result_.hand.four_bar);
    }
    if (auto base = table.table("base", true)) result_.hand.four_bar_base = pose(*base);
    result_.hand.four_bar_channels = channels(table, 2);
    table.finish();
  }

  /// The folder that a key names; `file` says that it holds the `kind` of model wanted.
  std::optional<fs::path> model_path(TomlTable& table, std::string_view key, const char* file,
                                     const char* kind) {
    const auto text = table.text(key, true);
    if (!text) return std::nullopt;
    const fs::path path = (folder_ / *text).lexically_normal();
    if (!fs::is_directory(path)) {
      table.report(key, "there is no model folder " + path.string(),
                   "expected a path from the folder of this file");
      return std::nullopt;
    }
    if (!fs::exists(path / file)) {
      table.report(key, fmt::format("{} is no {}: it has no {}", path.string(), kind, file),
                   fmt::format("expected the folder of a {}", kind));
      return std::nullopt;
    }
    result_.models.push_back(path);
    return path;
  }

  std::optional<Part> part_named(TomlTable& table, std::string_view key) {
    const auto path = model_path(table, key, "part.toml", "part");
    if (!path) return std::nullopt;
    return read_part(*path);
  }

  template <class Parameters>
  void take(TomlTable& table, std::string_view key, const Part& part, Parameters& into) {
    if (const auto* parameters = std::get_if<Parameters>(&part.parameters))
      into = *parameters;
    else
      table.report(key, part.name + " is another kind of part",
                   "expected a wrist for `wrist` and a four-bar for `four_bar`");
  }

  Transform pose(TomlTable& table) {
    Transform pose;
    if (const auto xyz = table.quantity("xyz", Shape::vector, Dimension::length, true))
      pose.translation = Eigen::Vector3d(xyz->values.data());
    if (const auto rpy = table.quantity("rpy", Shape::vector, Dimension::angle, false))
      pose.rotation = rotation_from_rpy(Eigen::Vector3d(rpy->values.data()));
    table.finish();
    return pose;
  }

  /// Wrist channels of a member, each used once in the hand.
  std::vector<int> channels(TomlTable& table, std::size_t tendons) {
    const auto text = table.text("channels", true);
    if (!text) return {};
    const auto list = channel_list(*text);
    if (!list) {
      table.report("channels", "\"" + *text + "\" is no list of channels",
                   "expected numbers from 1 and ranges, such as \"1-4, 9\"");
      return {};
    }
    if (list->size() != tendons)
      table.report("channels", std::to_string(list->size()) + " channels",
                   "expected one a tendon: " + std::to_string(tendons));
    for (const int channel : *list) {
      const std::string number = std::to_string(channel + 1);
      if (static_cast<std::size_t>(channel) >= result_.hand.wrist.forearm_points.size())
        table.report("channels", "the wrist has no channel " + number,
                     "expected 1 to " + std::to_string(result_.hand.wrist.forearm_points.size()));
      if (const auto [place, first] = used_.emplace(channel, table.path()); !first)
        table.report("channels", "channel " + number + " is taken by " + place->second,
                     "expected one tendon a channel");
    }
    return *list;
  }

  TomlTable root_;
  fs::path folder_;
  HandDescription result_;
  std::map<int, std::string> used_;
};

}  // namespace

bool is_hand_folder(const fs::path& folder) {
  return fs::exists(folder / "hand.toml");
}

HandDescription read_hand(const fs::path& folder) {
  const std::string name = (folder / "hand.toml").string();
  Findings findings;
  const std::string text = read_text(name, findings);
  findings.raise_if_any();
  std::map<std::string, std::string> provenance;
  TomlFile file{name, findings, provenance};
  const toml::table root = parse_toml(text, file);
  findings.raise_if_any();
  HandDescription result = HandReader(TomlTable(root, "", file), folder).read();
  std::size_t tendons = result.hand.four_bar_channels.size();
  for (const HandFinger& finger : result.hand.fingers) tendons += finger.channels.size();
  if (tendons != result.hand.wrist.forearm_points.size())
    findings.add({name, 1, 1}, std::to_string(tendons) + " of the wrist's channels have a tendon",
                 "expected all " + std::to_string(result.hand.wrist.forearm_points.size()));
  findings.raise_if_any();
  return result;
}

}  // namespace sinew
