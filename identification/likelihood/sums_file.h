// SPDX-License-Identifier: GPL-3.0-or-later
// A log's sums as a file (docs/fleets.md says what is in it).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identification/likelihood/log_sums.h"

namespace sinew::diagnosis {

/// What sums are of. Those of one fleet agree in all but the log's own part.
struct SumsOrigin {
  std::string program;                   ///< version of the program that made them
  std::string model;                     ///< its name
  std::string model_hash, columns_hash;  ///< SHA-256
  std::vector<std::string> reference;    ///< SHA-256 of the reference logs, in ascending order
  std::string settings;                  ///< all that changes a sum, in words
  // The log.
  std::string log, log_hash;  ///< file as given, SHA-256
  long log_rows = 0;
  double log_seconds = 0.0;
  std::vector<std::string> faults;  ///< what is to be said of it
};

struct SumsFile {
  SumsOrigin origin;
  LogSums sums;
};

/// CBOR (RFC 8949); arrays of numbers are those of RFC 8746, little-endian.
std::string sums_bytes(const SumsFile& file);

/// Throws std::runtime_error that names the file: it is none of sums, of another version of the
/// format, cut short, or its content is not what its SHA-256 says.
SumsFile read_sums(const std::filesystem::path& file);

/// Throws std::invalid_argument that names both and what they differ in, where sums are not of the
/// same model, columns, reference logs, settings and version of the program. `first`, `second`:
/// what to call them.
void check_same_fleet(const SumsOrigin& a, const std::string& first, const SumsOrigin& b,
                      const std::string& second);

}  // namespace sinew::diagnosis
