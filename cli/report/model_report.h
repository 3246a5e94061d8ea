// SPDX-License-Identifier: GPL-3.0-or-later
// A model on one page that needs nothing else.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/report/scene.h"
#include "generator/model.h"

namespace sinew {

/// What became of a function since the C was generated last.
struct ChangedFunction {
  std::string name;
  std::string change;  ///< "changed", "new", "removed"
  std::string detail;  ///< operations and results, in words
};

/// What one call costs on a board; nothing where it was not counted.
struct BoardCost {
  std::string board;     ///< "Cortex-A9"
  std::string function;  ///< with the model's prefix
  std::optional<long> instructions, bytes;
};

struct TableOfModel {
  std::string title;
  std::vector<std::string> headings;  ///< of numbers with a '#' in front
  std::vector<std::vector<std::string>> rows;
};

struct ModelReport {
  EmittedModel emitted;
  std::string kind;    ///< "finger or arm", "hand", "wrist", "motor", ...
  std::string folder;  ///< of the model, as it was given
  std::optional<DrawnScene> drawing;
  // Names of emitted functions; "" where the model does not have them.
  std::string lengths, coupling, stiffness, gravity;
  /// Of a hand, instead of `gravity`: gravity in the fingers' base frames, and the torques of their
  /// `coordinates`, the first ones held, that it takes.
  struct Weighed {
    std::string gravity, torques;
    int coordinates = 0;
  };
  Weighed weighed;
  std::vector<int> held;      ///< coordinates that tendons have to hold
  std::vector<int> free;      ///< columns of the coupling that something else holds
  double force_high = 100.0;  ///< N
  double stiffness_low = 1.0e3, stiffness_high = 5.0e4;  ///< N/m
  std::vector<TableOfModel> tables;                      ///< bodies, joints, tendons
  std::vector<BoardCost> boards;
  std::string boards_from;  ///< the table's file; "" where there was none
  std::vector<ChangedFunction> changes;
  std::string compared_with;         ///< folder of the C before; "" where there is none
  std::vector<std::string> missing;  ///< what this kind of model does not have, and why
  std::vector<std::string> warnings;
  std::string equations;  ///< HTML; "" where there are none
};

/// The page: its content security policy lets nothing in from outside. The same report gives the
/// same bytes.
std::string model_page(const ModelReport& report);

/// Rows of a table "board,function,instructions,bytes" that are of the model `name`; an empty cell
/// is not known. Throws std::runtime_error with file and line for a row that is no such row.
std::vector<BoardCost> read_board_costs(const std::string& file, const std::string& name);

}  // namespace sinew
