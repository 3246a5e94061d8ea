// SPDX-License-Identifier: GPL-3.0-or-later
// Signals of a recording by name. Copies of a recording share them until one of them is written.
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <string>

namespace sinew::diagnosis {

/// Each is samples x columns.
class Signals {
 public:
  using Map = std::map<std::string, std::shared_ptr<Eigen::MatrixXd>>;

  /// To be written: what other recordings share stays as it is. A new one is empty.
  Eigen::MatrixXd& operator[](const std::string& name) {
    std::shared_ptr<Eigen::MatrixXd>& signal = map_[name];
    if (!signal)
      signal = std::make_shared<Eigen::MatrixXd>();
    else if (signal.use_count() > 1)
      signal = std::make_shared<Eigen::MatrixXd>(*signal);
    return *signal;
  }
  /// Throws std::out_of_range where there is none.
  const Eigen::MatrixXd& at(const std::string& name) const { return *map_.at(name); }
  /// Null where there is none.
  const Eigen::MatrixXd* find(const std::string& name) const {
    const auto found = map_.find(name);
    return found == map_.end() ? nullptr : found->second.get();
  }
  std::size_t count(const std::string& name) const { return map_.count(name); }
  Map::const_iterator begin() const { return map_.begin(); }
  Map::const_iterator end() const { return map_.end(); }

 private:
  Map map_;
};

}  // namespace sinew::diagnosis
