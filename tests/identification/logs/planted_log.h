// SPDX-License-Identifier: GPL-3.0-or-later
// Clean drive logs of several kinds, and the faults that a test plants in them.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "identification/logs/channel_map.h"
#include "identification/logs/log.h"

namespace sinew::test {

/// A log as cells of text, so that a fault can be planted anywhere.
struct PlantedLog {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> cells;  ///< [row][column]
  std::vector<ChannelSpec> specs;
  char delimiter = ',';

  int column(const std::string& begins) const;  ///< index from 0 of the header that begins so
  std::string text() const;
};

/// Kinds of clean logs, 0 .. clean_kinds - 1: multi-sine with an encoder; trapezoids with rests;
/// noise-free simulation; 3 kHz with rounded stamps; slow log with a velocity channel; linear drive
/// with a chattering force.
constexpr int clean_kinds = 6;
PlantedLog clean_log(int kind, std::mt19937_64& random);

/// What was planted: the finding expected, and where (row 0: anywhere).
struct Planted {
  FaultKind kind = FaultKind::gap;
  std::string channel;
  long row = 0;         ///< line of the file
  bool either = false;  ///< of two columns either may be named
};

/// Kinds of planted faults, 0 .. planted_kinds - 1. What an effort's motion tells of it needs a
/// model (tests/identification/subjects/lone_readings.cpp).
constexpr int planted_kinds = 28;
std::string planted_name(int fault);
Planted plant(int fault, PlantedLog& log, std::mt19937_64& random);

/// Writes the text to a file of this process and gives its path.
std::string write_file(const std::string& name, const std::string& text);

}  // namespace sinew::test
