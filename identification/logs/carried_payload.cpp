// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/carried_payload.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "identification/logs/units.h"

namespace sinew {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw std::invalid_argument("--condition '" + text + "': " + why +
                              "; expected [LOG:]payload[@LINK]=MASS kg [at X, Y, Z m]");
}

/// The numbers of a list such as "0, 0, 50 mm", in SI by the unit at its end.
std::vector<double> quantities(std::string_view list, const char* wanted, const std::string& text) {
  std::vector<double> values;
  list = trimmed(list);
  while (!list.empty()) {
    double value = 0.0;
    const auto parsed = std::from_chars(list.data(), list.data() + list.size(), value);
    if (parsed.ec != std::errc() || !std::isfinite(value)) break;
    values.push_back(value);
    list = trimmed(list.substr(static_cast<std::size_t>(parsed.ptr - list.data())));
    if (list.starts_with(',')) list = trimmed(list.substr(1));
  }
  const auto unit = parse_unit(list);
  if (values.empty()) refuse(text, "no number is there");
  if (list.empty() || !unit || unit->dimension != parse_unit(wanted)->dimension)
    refuse(text, "'" + std::string(list) + "' is no unit such as " + wanted);
  for (double& value : values) value *= unit->factor;
  return values;
}

bool is_of(const CarriedPayload& payload, const std::string& file) {
  return payload.log.empty() || payload.log == file ||
         payload.log == std::filesystem::path(file).filename().string();
}

}  // namespace

CarriedPayload carried_payload(const std::string& text) {
  const std::string key = "payload";
  const std::size_t equals = text.find('='), word = text.rfind(key, equals);
  if (equals == std::string::npos || word == std::string::npos ||
      (word > 0 && text[word - 1] != ':' && !trimmed(text.substr(0, word)).ends_with(':')))
    refuse(text, "a log may say which payload it carried, and nothing else");
  CarriedPayload payload;
  std::string_view log = trimmed(std::string_view(text).substr(0, word));
  if (!log.empty()) payload.log = trimmed(log.substr(0, log.size() - 1));
  std::string_view link =
      trimmed(std::string_view(text).substr(word + key.size(), equals - word - key.size()));
  if (!link.empty() && (link.front() != '@' || trimmed(link.substr(1)).empty()))
    refuse(text, "'" + std::string(link) + "' is no @LINK");
  if (!link.empty()) payload.link = trimmed(link.substr(1));
  const std::string value = text.substr(equals + 1);
  const std::size_t at = value.find(" at ");
  const std::vector<double> mass = quantities(value.substr(0, at), "kg", text);
  if (mass.size() != 1 || !(mass.front() >= 0.0)) refuse(text, "a mass is one number from 0");
  payload.mass = mass.front();
  if (at == std::string::npos) return payload;
  const std::vector<double> centre = quantities(value.substr(at + 4), "m", text);
  if (centre.size() != 3) refuse(text, "a place has three coordinates");
  payload.centre = Eigen::Vector3d(centre[0], centre[1], centre[2]);
  return payload;
}

const CarriedPayload* payload_of(const std::vector<CarriedPayload>& told, const std::string& file) {
  const CarriedPayload* found = nullptr;
  for (const CarriedPayload& payload : told) {
    if (!is_of(payload, file)) continue;
    if (found)
      throw std::invalid_argument("--condition: two payloads are told of " + file +
                                  "; a log has one, or says it in a column 'payload [kg]'");
    found = &payload;
  }
  return found;
}

void check_payloads(const std::vector<CarriedPayload>& told,
                    const std::vector<std::string>& files) {
  for (const CarriedPayload& payload : told)
    if (std::none_of(files.begin(), files.end(),
                     [&](const std::string& file) { return is_of(payload, file); }))
      throw std::invalid_argument("--condition: no log is called '" + payload.log +
                                  "'; expected a file of --log or --holdout");
}

}  // namespace sinew
