// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/guess_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>

#include "identification/logs/units.h"

namespace sinew {
namespace {

using Words = std::set<std::string>;

/// "Joint1 motorTorque" -> joint, 1, motor, torque; and joint1, motortorque.
Words words_of(const std::string& name) {
  Words words;
  std::string part, whole;
  const auto end = [&](std::string& word) {
    if (!word.empty()) words.insert(word);
    word.clear();
  };
  char before = ' ';
  for (const char c : name + " ") {
    const auto u = static_cast<unsigned char>(c), b = static_cast<unsigned char>(before);
    if (!std::isalnum(u)) {
      end(part);
      end(whole);
    } else {
      const bool new_word = (std::isupper(u) && std::islower(b)) ||
                            (std::isdigit(u) != std::isdigit(b) && std::isalnum(b));
      if (new_word) end(part);
      part += static_cast<char>(std::tolower(u));
      whole += static_cast<char>(std::tolower(u));
    }
    before = c;
  }
  return words;
}

bool any_of(const Words& words, const Words& wanted) {
  return std::any_of(wanted.begin(), wanted.end(),
                     [&](const std::string& word) { return words.count(word) != 0; });
}

const Words& words_for(ChannelRole role) {
  static const Words reference{"ref",     "reference", "cmd",      "command", "des",
                               "desired", "target",    "setpoint", "goal"};
  static const Words position{"pos", "position", "angle",   "q",   "theta",
                              "phi", "x",        "encoder", "enc", "deg"};
  static const Words velocity{"vel", "velocity", "speed", "omega", "qd",
                              "dq",  "qdot",     "v",     "rate",  "w"};
  static const Words effort{"torque", "tau", "effort",  "trq", "tq", "moment",
                            "force",  "f",   "current", "i",   "iq", "amp"};
  static const Words current{"current", "i", "iq", "amp"};
  static const Words other{"load", "force", "f", "tension", "count", "counts", "adc"};
  switch (role) {
    case ChannelRole::reference:
      return reference;
    case ChannelRole::position:
      return position;
    case ChannelRole::velocity:
      return velocity;
    case ChannelRole::effort:
      return effort;
    case ChannelRole::current:
      return current;
    default:
      return other;
  }
}

struct LogHeaderCell {
  std::string whole, unit;
  Words words;
};

/// The place that a channel is at: a joint's name, and its number among all.
struct ChannelPlace {
  std::string joint;  ///< "" where the model has one drive
  int number = 0;     ///< from 1
};

ChannelPlace place_of(const ChannelSpec& spec, const std::vector<std::string>& joints) {
  ChannelPlace found;
  for (std::size_t i = 0; i < joints.size(); ++i)
    for (const char* prefix : {"", "q_", "qd_", "tau_"})
      for (const char* ending : {"", "_ref"})
        if (spec.name == prefix + joints[i] + ending) found = {joints[i], static_cast<int>(i) + 1};
  const std::size_t digits = spec.name.find_last_not_of("0123456789") + 1;
  if (found.joint.empty() && digits < spec.name.size())
    found.number = std::stoi(spec.name.substr(digits));
  return found;
}

/// Columns that count from 0 hold a 0 among their numbers.
bool counts_from_zero(const std::vector<LogHeaderCell>& cells) {
  return std::any_of(cells.begin(), cells.end(),
                     [](const LogHeaderCell& cell) { return cell.words.count("0") != 0; });
}

/// By the joint's name, all words of it, or by its number.
bool is_place(const LogHeaderCell& cell, const ChannelPlace& place, bool from_zero) {
  if (place.number == 0) return true;
  const Words name = words_of(place.joint);
  const auto is_there = [&](const std::string& word) { return cell.words.count(word) != 0; };
  const auto says_something = [](const std::string& word) {
    return word.size() > 1 && !std::isdigit(static_cast<unsigned char>(word[0]));
  };
  if (std::any_of(name.begin(), name.end(), says_something) &&
      std::all_of(name.begin(), name.end(), is_there))
    return true;
  return is_there(std::to_string(place.number - (from_zero ? 1 : 0)));
}

/// 0: cannot be; more is better.
int score(const LogHeaderCell& cell, const ChannelSpec& spec, const ChannelPlace& place,
          bool from_zero) {
  const Words& references = words_for(ChannelRole::reference);
  if ((spec.role == ChannelRole::reference) != any_of(cell.words, references)) return 0;
  if (!is_place(cell, place, from_zero)) return 0;
  const std::optional<Unit> wanted = parse_unit(spec.unit);
  const bool si = cell.unit == kWhateverSi;
  const std::optional<Unit> given = si ? wanted : parse_unit(cell.unit);
  const bool amperes =
      given && spec.role == ChannelRole::effort && convertible(*given, *parse_unit("A"));
  if (!cell.unit.empty() && !(given && wanted && convertible(*given, *wanted)) && !amperes)
    return 0;
  const bool named =
      spec.role == ChannelRole::reference || any_of(cell.words, words_for(spec.role));
  // A count has the unit 1, which says nothing.
  const bool by_unit = given && !si && spec.unit != "1";
  return (named ? 2 : 0) + (by_unit ? 1 : 0);
}

std::vector<LogHeaderCell> cells_of(const std::vector<std::string>& header) {
  std::vector<LogHeaderCell> cells;
  for (const std::string& text : header) {
    NameAndUnit parts = split_name_and_unit(text);
    if (parts.unit.empty())
      if (const auto suffix = split_unit_suffix(parts.name)) parts = *suffix;
    cells.push_back({std::string(trimmed(text)), parts.unit, words_of(parts.name)});
  }
  return cells;
}

class Guesser {
 public:
  Guesser(const std::vector<std::string>& header, const std::vector<std::string>& joints)
      : header_(header), joints_(joints), cells_(cells_of(header)), used_(cells_.size(), false) {}

  /// Columns that the reader finds by itself are no other channel's.
  bool is_understood(const ChannelSpec& spec) {
    std::vector<std::string> names = spec.also;
    names.push_back(spec.name);
    if (spec.name == "time") names.insert(names.end(), {"t", "timestamp"});
    for (const std::string& name : names)
      for (std::size_t i = 0; i < cells_.size(); ++i)
        if (!used_[i] && !cells_[i].unit.empty() && names_channel({header_[i]}, {}, name))
          return used_[i] = true;
    return false;
  }

  void guess(const ChannelSpec& spec, ChannelGuess& guess) {
    const ChannelPlace place = place_of(spec, joints_);
    const bool from_zero = counts_from_zero(cells_);
    int best = 0;
    std::vector<std::size_t> hits;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const int points = used_[i] ? 0 : score(cells_[i], spec, place, from_zero);
      if (points > best) hits.clear();
      best = std::max(best, points);
      if (points > 0 && points == best) hits.push_back(i);
    }
    for (const std::size_t i : hits) guess.columns.push_back(cells_[i].whole);
    if (hits.empty()) return;
    guess.kind = hits.size() > 1                ? GuessKind::ambiguous
                 : cells_[hits[0]].unit.empty() ? GuessKind::unit_less
                                                : GuessKind::guessed;
    if (hits.size() == 1) used_[hits[0]] = true;
  }

  void guess_time(ChannelGuess& guess) {
    static const Words names{"time", "t", "timestamp", "stamp", "sec", "seconds", "clock"};
    for (std::size_t i = 0; i < cells_.size() && guess.columns.empty(); ++i) {
      if (used_[i] || !any_of(cells_[i].words, names)) continue;
      used_[i] = true;
      guess.columns = {cells_[i].whole};
      guess.kind = cells_[i].unit.empty() ? GuessKind::unit_less : GuessKind::guessed;
    }
  }

 private:
  const std::vector<std::string>& header_;
  const std::vector<std::string>& joints_;
  std::vector<LogHeaderCell> cells_;
  std::vector<bool> used_;
};

std::string toml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return quoted + "\"";
}

std::string toml_key(const std::string& name) {
  const char* bare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return name.find_first_not_of(bare) == name.npos ? name : toml_text(name);
}

/// A position is the integral of its velocity where the log has that alone.
void need_no_position_beside_velocity(const std::vector<ChannelSpec>& specs,
                                      std::vector<ChannelGuess>& guesses) {
  for (std::size_t i = 0; i < specs.size(); ++i)
    for (std::size_t k = 0; k < specs.size(); ++k)
      if (specs[i].role == ChannelRole::position && specs[k].role == ChannelRole::velocity &&
          specs[i].group == specs[k].group && guesses[i].kind == GuessKind::none &&
          (guesses[k].kind == GuessKind::understood || guesses[k].kind == GuessKind::guessed))
        guesses[i].required = false;
}

}  // namespace

std::vector<ChannelGuess> guess_channels(const std::vector<std::string>& header,
                                         const std::vector<ChannelSpec>& specs,
                                         const std::vector<std::string>& joints) {
  ChannelSpec time;
  time.name = "time";
  time.unit = "s";
  time.required = true;
  std::vector<ChannelSpec> all{time};
  all.insert(all.end(), specs.begin(), specs.end());
  Guesser guesser(header, joints);
  std::vector<ChannelGuess> guesses;
  for (const ChannelSpec& spec : all) {
    guesses.push_back({spec.name, spec.unit, spec.required});
    if (guesser.is_understood(spec)) guesses.back().kind = GuessKind::understood;
  }
  // What the model needs comes first: an optional channel takes no column from it.
  for (const bool required : {true, false})
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].required != required || guesses[i].kind != GuessKind::none) continue;
      i == 0 ? guesser.guess_time(guesses[i]) : guesser.guess(all[i], guesses[i]);
    }
  need_no_position_beside_velocity(all, guesses);
  return guesses;
}

std::string guessed_channels_toml(const std::vector<ChannelGuess>& guesses,
                                  const std::string& log) {
  std::string text = fmt::format(
      "# Which column of a log is which channel, guessed from the header of {}.\n"
      "# Confirm every line before it is used. A line that begins with # is not "
      "read.\n\n[channels]\n",
      log);
  for (const ChannelGuess& guess : guesses) {
    const std::string key = toml_key(guess.channel);
    switch (guess.kind) {
      case GuessKind::understood:
        text += fmt::format("# {} is understood as it is\n", key);
        break;
      case GuessKind::guessed:
        text += fmt::format("{} = {}\n", key, toml_text(guess.columns[0]));
        break;
      case GuessKind::unit_less:
        text += fmt::format("# {} = {}  # the header names no unit: put it right\n", key,
                            toml_text(guess.columns[0] + " [" + guess.unit + "]"));
        break;
      case GuessKind::ambiguous:
        text += fmt::format("# {} may be one of:", key);
        for (const std::string& column : guess.columns) text += " " + toml_text(column);
        text += "\n";
        break;
      case GuessKind::none:
        if (guess.required)
          text += fmt::format("# {} = \"? [{}]\"  # needed; no column looks like it\n", key,
                              guess.unit);
        break;
    }
  }
  return text;
}

}  // namespace sinew
