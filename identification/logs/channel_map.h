// SPDX-License-Identifier: GPL-3.0-or-later
// Which column of a file is which channel of a model.
#pragma once

#include <string>
#include <vector>

#include "identification/logs/channel_specs.h"
#include "identification/logs/log.h"

namespace sinew {

/// A column that is read: where it is, and how it becomes SI.
struct MappedColumn {
  int column = 0;  ///< from 1
  double factor = 1.0;
  ChannelSpec spec;
  bool is_current = false;  ///< an effort that is logged as a current
  bool is_rate = false;     ///< a position that is logged as a velocity: the channel's integral
};

struct ColumnMap {
  MappedColumn time;
  std::vector<MappedColumn> channels;  ///< in the order of the specifications
  std::vector<DataFault> notes;        ///< units taken from a name's end, columns that stay unused
};

/// Whether map_columns() would find a channel of this name in the header, or `overrides` name it.
bool names_channel(const std::vector<std::string>& header,
                   const std::vector<std::string>& overrides, const std::string& channel);

/// Finds every channel of `specs` in the header. `overrides` are texts of --map:
/// "channel=column name [unit]" or "channel=#3 [unit]". Names match exactly, else without regard
/// to case. A position that is not there, or whose column has a velocity's unit, is the integral of
/// a velocity. Throws LogError, each finding naming the header's row and the column: a required
/// channel is not there, a unit is missing, unknown or of another kind, a name occurs twice.
ColumnMap map_columns(const std::vector<std::string>& header, const std::vector<ChannelSpec>& specs,
                      const std::vector<std::string>& overrides, const std::string& file,
                      long header_row);

}  // namespace sinew
