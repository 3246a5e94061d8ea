// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/sums_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "identification/logs/sha256.h"
#include "symbolic/files/limits.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

constexpr const char* kFormat = "sinew sums";
constexpr int kVersion = 1;
constexpr std::uint64_t kDoubles = 86;  // RFC 8746: float64, little-endian
static_assert(std::endian::native == std::endian::little);

Json doubles(const double* values, Index count) {
  Bytes bytes(static_cast<std::size_t>(count) * sizeof(double));
  std::memcpy(bytes.data(), values, bytes.size());
  return Json::binary(std::move(bytes), kDoubles);
}

Json doubles(const MatrixXd& values) {
  return doubles(values.data(), values.size());
}

/// Column by column, from the diagonal down.
VectorXd lower_triangle(const RegionProducts& gram) {
  VectorXd lower(gram.size() * (gram.size() + 1) / 2);
  Index at = 0;
  for (Index c = 0; c < gram.size(); ++c)
    for (Index r = c; r < gram.size(); ++r) lower(at++) = gram(r, c);
  return lower;
}

VectorXd read_doubles(const Json& from, const char* name, Index count) {
  const auto& bytes = from.at(name).get_binary();
  if (bytes.size() != static_cast<std::size_t>(count) * sizeof(double))
    throw std::runtime_error(
        fmt::format("'{}' has {} bytes; expected {} numbers of 8", name, bytes.size(), count));
  VectorXd values(count);
  std::memcpy(values.data(), bytes.data(), bytes.size());
  if (!values.allFinite()) throw std::runtime_error(fmt::format("'{}' is not finite", name));
  return values;
}

std::string hash_of(const Bytes& bytes) {
  Sha256 hash;
  hash.update(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return hash.finish();
}

Json json_of(const SumsOrigin& o) {
  return {{"program", o.program},
          {"model", o.model},
          {"model_sha256", o.model_hash},
          {"columns_sha256", o.columns_hash},
          {"reference_sha256", o.reference},
          {"settings", o.settings},
          {"log", o.log},
          {"log_sha256", o.log_hash},
          {"log_rows", o.log_rows},
          {"log_seconds", o.log_seconds},
          {"faults", o.faults}};
}

SumsOrigin origin_in(const Json& j) {
  SumsOrigin o;
  j.at("program").get_to(o.program);
  j.at("model").get_to(o.model);
  j.at("model_sha256").get_to(o.model_hash);
  j.at("columns_sha256").get_to(o.columns_hash);
  j.at("reference_sha256").get_to(o.reference);
  j.at("settings").get_to(o.settings);
  j.at("log").get_to(o.log);
  j.at("log_sha256").get_to(o.log_hash);
  j.at("log_rows").get_to(o.log_rows);
  j.at("log_seconds").get_to(o.log_seconds);
  j.at("faults").get_to(o.faults);
  return o;
}

Json json_of(const LogSums& sums) {
  const ColumnSums& c = sums.columns;
  return {{"free", c.free},
          {"width", c.width},
          {"channels", c.measured.size()},
          {"gram", doubles(lower_triangle(c.gram))},
          {"target", doubles(c.target)},
          {"deviance", c.deviance},
          {"rows", c.rows},
          {"energy", doubles(c.energy)},
          {"acting", doubles(c.acting)},
          {"measured", doubles(c.measured)},
          {"samples", doubles(c.samples)},
          {"error", doubles(sums.error)}};
}

LogSums sums_in(const Json& j) {
  LogSums sums;
  ColumnSums& c = sums.columns;
  j.at("free").get_to(c.free);
  j.at("width").get_to(c.width);
  const Index channels = j.at("channels").get<Index>();
  constexpr auto most = static_cast<Index>(limits::sums_columns);
  Index own = 0;
  for (const Index width : c.width)
    if (width < 0 || (own += width) > most) throw std::runtime_error("too many columns");
  if (c.free < 0 || c.free > most || channels < 1 || channels > most)
    throw std::runtime_error("too many columns");
  const Index all = c.free + own;
  const VectorXd lower = read_doubles(j, "gram", all * (all + 1) / 2);
  MatrixXd gram = MatrixXd::Zero(all, all);
  Index at = 0;
  for (Index k = 0; k < all; ++k) {
    gram.col(k).tail(all - k) = lower.segment(at, all - k);
    at += all - k;
  }
  c.gram = RegionProducts(gram);
  c.target = read_doubles(j, "target", all);
  j.at("deviance").get_to(c.deviance);
  j.at("rows").get_to(c.rows);
  c.energy = read_doubles(j, "energy", channels * own).reshaped(channels, own);
  c.acting = read_doubles(j, "acting", own);
  c.measured = read_doubles(j, "measured", channels);
  c.samples = read_doubles(j, "samples", channels);
  sums.error = read_doubles(j, "error", channels);
  return sums;
}

Bytes bytes_of(const std::filesystem::path& file) {
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(file, failed);
  std::ifstream in(file, std::ios::binary);
  if (failed || !in) throw std::runtime_error("cannot be read; expected a file of sums");
  if (size > limits::sums_bytes)
    throw std::runtime_error(
        fmt::format("has {} bytes; expected {} at most", size, limits::sums_bytes));
  Bytes bytes(static_cast<std::size_t>(size));
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!in) throw std::runtime_error("cannot be read to its end");
  return bytes;
}

/// What the file says, its content checked.
Json content_of(const Bytes& bytes) {
  const Json whole = Json::from_cbor(bytes, true, false, Json::cbor_tag_handler_t::store);
  if (whole.is_discarded() || !whole.is_object() || whole.value("format", "") != kFormat)
    throw std::runtime_error("is no whole file of sums; expected one that --summarise wrote");
  if (whole.at("version") != kVersion)
    throw std::runtime_error(fmt::format("is of version {} of the format; expected {}",
                                         whole.at("version").dump(), kVersion));
  const Bytes& content = whole.at("content").get_binary();
  if (hash_of(content) != whole.at("sha256").get<std::string>())
    throw std::runtime_error("its content is not what its SHA-256 says; write it again");
  return Json::from_cbor(content, true, true, Json::cbor_tag_handler_t::store);
}

}  // namespace

std::string sums_bytes(const SumsFile& file) {
  const Json content{{"origin", json_of(file.origin)}, {"sums", json_of(file.sums)}};
  Bytes bytes = Json::to_cbor(content);
  std::string hash = hash_of(bytes);
  const Json whole{{"format", kFormat},
                   {"version", kVersion},
                   {"sha256", std::move(hash)},
                   {"content", Json::binary(std::move(bytes))}};
  const Bytes all = Json::to_cbor(whole);
  return {all.begin(), all.end()};
}

SumsFile read_sums(const std::filesystem::path& file) {
  try {
    const Json content = content_of(bytes_of(file));
    return {origin_in(content.at("origin")), sums_in(content.at("sums"))};
  } catch (const nlohmann::json::exception& e) {
    throw std::runtime_error(file.string() + ": is no file of sums: " + e.what());
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(file.string() + ": " + e.what());
  }
}

void check_same_fleet(const SumsOrigin& a, const std::string& first, const SumsOrigin& b,
                      const std::string& second) {
  const auto check = [&](const char* what, const std::string& of_a, const std::string& of_b) {
    if (of_a != of_b)
      throw std::invalid_argument(
          fmt::format("{} and {} do not add up: they differ in the {}: {} "
                      "and {}",
                      first, second, what, of_a, of_b));
  };
  check("program's version", a.program, b.program);
  check("model", a.model + " " + a.model_hash, b.model + " " + b.model_hash);
  check("settings", a.settings, b.settings);
  check("reference logs (SHA-256)", fmt::format("{}", fmt::join(a.reference, " ")),
        fmt::format("{}", fmt::join(b.reference, " ")));
  check("columns (SHA-256)", a.columns_hash, b.columns_hash);
}

}  // namespace sinew::diagnosis
