// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/recorded_run.h"

#include <openssl/evp.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace sinew {
namespace {

constexpr double instants_of_a_run = 400.0;

void append(std::string& bytes, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(static_cast<unsigned char>(bits >> shift));
}

std::string base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

}  // namespace

RecordedRun::RecordedRun(std::vector<std::string> columns, double duration)
    : columns_(std::move(columns)),
      length_(duration / instants_of_a_run),
      values_(columns_.empty() ? 0 : columns_.size() - 1) {}

void RecordedRun::add(const std::vector<double>& row) {
  const long at = std::lround(std::floor(row.at(0) / length_ + 1e-9));
  const bool opens = at != last_;
  last_ = at;
  if (opens) times_.push_back(static_cast<float>(row[0]));
  for (std::size_t k = 0; k < values_.size(); ++k) {
    const auto value = static_cast<float>(row.at(k + 1));
    auto& [first, low, high] = values_[k];
    if (opens) {
      for (auto* list : {&first, &low, &high}) list->push_back(value);
    } else {
      low.back() = std::min(low.back(), value);
      high.back() = std::max(high.back(), value);
    }
  }
}

std::string RecordedRun::packed_times() const {
  std::string bytes;
  for (const float time : times_) append(bytes, time);
  return base64(bytes);
}

std::string RecordedRun::packed_values() const {
  std::string bytes;
  for (const auto& channel : values_)
    for (const std::vector<float>& list : channel)
      for (const float value : list) append(bytes, value);
  return base64(bytes);
}

void RecordedBooks::add(double now, double value, const std::vector<double>& powers) {
  if (time.empty()) {
    start_ = value;
    work.resize(powers.size());
  } else if (now < time.back() + gap_) {
    return;
  }
  time.push_back(now);
  energy.push_back(value);
  double sum = 0.0;
  for (std::size_t i = 0; i < powers.size(); ++i) {
    work[i].push_back(powers[i]);
    sum += powers[i];
  }
  missing.push_back(value - start_ - sum);
}

}  // namespace sinew
