// SPDX-License-Identifier: GPL-3.0-or-later
// Logs that are no text: told by their first bytes and written out as CSV text, so that one reader
// with one set of checks is behind every format.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace sinew {

/// One column of a log. `name` as in a header, "q_20 [rad]" where the file says the unit.
struct LogColumn {
  std::string name;
  std::vector<double> values;
};

/// CSV text of a MAT, HDF5, rosbag2 or MCAP file, or of a rosbag2 folder (bag_folder.h), in a
/// temporary file without a name, at its beginning; nullptr for any other file. Throws
/// std::runtime_error "file:0:0: ..." where the file cannot be understood, or its format needs a
/// library that this program was built without.
std::FILE* converted_log(const std::string& path);

/// The files that a log is made of, which its digest is of: itself, or those of a rosbag2 folder.
/// Throws std::runtime_error as above.
std::vector<std::string> files_of_log(const std::string& path);

/// Columns of equal length: every real vector and every column of a matrix, the longest ones.
/// Throw std::runtime_error as above. The second one reads HDF5, which newer MAT files (7.3) are.
std::vector<LogColumn> read_mat(const std::string& path);
std::vector<LogColumn> read_hdf5(const std::string& path);
/// The joint states of a recording of ROS 2 (joint_states.h). Throw std::runtime_error as above.
std::vector<LogColumn> read_rosbag2(const std::string& path);
std::vector<LogColumn> read_mcap(const std::string& path);

/// The columns of the length that most of them have, in their order; the others are left out.
std::vector<LogColumn> of_one_length(std::vector<LogColumn> columns, const std::string& path);

}  // namespace sinew
