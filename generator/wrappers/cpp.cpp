// SPDX-License-Identifier: GPL-3.0-or-later
// A C++20 header: the emitted functions on std::span with fixed sizes, and, where Eigen is found,
// on its matrices.
#include <fmt/format.h>

#include "generator/wrappers/template_text.h"

namespace sinew {
namespace {

const char* const cpp_head = R"(// SPDX-License-Identifier: BSD-2-Clause
// @DESCRIPTION@
//
// Made by: sinew generate (--cpp). Do not edit: change the model and generate again.
//
// SI units; matrices row-major. Each function stands here twice: on std::span, without a copy, and,
// where Eigen is found, on Eigen's matrices, returning its result.
#pragma once

#include <array>
#include <span>
#include <string_view>

#if !defined(SINEW_WITHOUT_EIGEN) && __has_include(<Eigen/Core>)
#include <Eigen/Core>
#define SINEW_@UPPER@_EIGEN 1
#endif

#include "@MODEL@.h"

namespace sinew_@MODEL@ {

inline constexpr std::string_view model = "@MODEL@";
inline constexpr std::string_view sha256 = "@HASH@";
@NAMES@
#ifdef SINEW_@UPPER@_EIGEN
/// As the emitted C keeps it: row-major, but for a column, which has one order only.
template <int rows, int cols>
using Matrix = Eigen::Matrix<@SCALAR@, rows, cols,
                             cols == 1 && rows != 1 ? int(Eigen::ColMajor) : int(Eigen::RowMajor)>;

/// An array of the emitted C seen as a matrix, without a copy.
template <int rows, int cols = 1>
Eigen::Map<Matrix<rows, cols>> as_matrix(std::span<@SCALAR@, rows * cols> array) {
  return Eigen::Map<Matrix<rows, cols>>(array.data());
}
template <int rows, int cols = 1>
Eigen::Map<const Matrix<rows, cols>> as_matrix(std::span<const @SCALAR@, rows * cols> array) {
  return Eigen::Map<const Matrix<rows, cols>>(array.data());
}
#endif
@FUNCTIONS@
}  // namespace sinew_@MODEL@
)";

const char* const cpp_cmake = R"(# SPDX-License-Identifier: BSD-2-Clause
# Made by: sinew generate (--cpp). add_subdirectory() this folder and link to sinew_cpp_@MODEL@.
cmake_minimum_required(VERSION 3.16)
project(sinew_cpp_@MODEL@ LANGUAGES C CXX)
add_library(sinew_cpp_@MODEL@ STATIC source/@MODEL@.c)
set_target_properties(sinew_cpp_@MODEL@ PROPERTIES C_STANDARD 11 POSITION_INDEPENDENT_CODE ON)
# The loops over many states, @MODEL@_batch.h, for those who link to them: they take longer to compile.
add_library(sinew_cpp_@MODEL@_batch STATIC EXCLUDE_FROM_ALL source/host/@MODEL@_batch.c)
set_target_properties(sinew_cpp_@MODEL@_batch PROPERTIES C_STANDARD 11 POSITION_INDEPENDENT_CODE ON)
target_include_directories(sinew_cpp_@MODEL@_batch PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/source
                                                         ${CMAKE_CURRENT_SOURCE_DIR}/source/host)
target_compile_options(sinew_cpp_@MODEL@_batch PRIVATE -O3 -ffp-contract=off -fno-math-errno
                                                      -fno-tree-slp-vectorize)
target_include_directories(sinew_cpp_@MODEL@ PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}
                                                   ${CMAKE_CURRENT_SOURCE_DIR}/source)
target_compile_features(sinew_cpp_@MODEL@ INTERFACE cxx_std_20)
# Under these the emitted C gives the same bits on every machine.
target_compile_options(sinew_cpp_@MODEL@ PRIVATE -O2 -ffp-contract=off -fno-math-errno
                                                -fno-tree-slp-vectorize)
find_package(Eigen3 QUIET NO_MODULE)
if(TARGET Eigen3::Eigen)
  target_link_libraries(sinew_cpp_@MODEL@ PUBLIC Eigen3::Eigen)
endif()
)";

std::string cpp_upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string cpp_list(const std::string& list, const std::vector<std::string>& names) {
  std::string text =
      fmt::format("inline constexpr std::array<std::string_view, {}> {}{{", names.size(), list);
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}\n    \"{}\"", i ? "," : "", names[i]);
  return text + "};\n";
}

std::string cpp_names(const WrappedModel& model) {
  std::vector<std::string> joints;
  for (const WrappedJoint& joint : model.joints) joints.push_back(joint.name);
  return cpp_list("joints", joints) + cpp_list("tendons", model.tendons) +
         cpp_list("frames", model.frames);
}

std::string cpp_comment(const WrappedFunction& function) {
  std::string text = fmt::format("\n/// {}{}\n", function.doc,
                                 function.equation.empty() ? "" : " " + function.equation);
  for (const WrappedArray& array : function.inputs)
    text += fmt::format("///   in  {}: {}\n", array.name, array_text(array));
  for (const WrappedArray& array : function.outputs)
    text += fmt::format("///   out {}: {}\n", array.name, array_text(array));
  return text;
}

/// As the emitted C takes a variable of that name.
std::string argument(const WrappedArray& array, const std::string& name) {
  if (array.by_value) return name;
  return array.is_status() ? "&" + name : name + ".data()";
}

std::string span_form(const WrappedModel& model, const WrappedFunction& function) {
  std::string parameters, arguments;
  const auto add = [&](const WrappedArray& array, const char* constness) {
    const std::string type = array.by_value      ? model.scalar
                             : array.is_status() ? "int&"
                                                 : fmt::format("std::span<{}{}, {}>", constness,
                                                               model.scalar, array.size());
    parameters += fmt::format("{}{} {}", parameters.empty() ? "" : ",\n    ", type, array.name);
    arguments += (arguments.empty() ? "" : ", ") + argument(array, array.name);
  };
  for (const WrappedArray& array : function.inputs) add(array, "const ");
  for (const WrappedArray& array : function.outputs) add(array, "");
  return cpp_comment(function) + fmt::format("inline void {}(\n    {}) {{\n  ::{}_{}({});\n}}\n",
                                             function.name, parameters, model.name, function.name,
                                             arguments);
}

/// Of a variable that holds it, beside Eigen.
std::string matrix_type(const WrappedModel& model, const WrappedArray& array) {
  if (array.by_value) return model.scalar;
  return array.is_status() ? "int" : fmt::format("Matrix<{}, {}>", array.rows, array.cols);
}

/// One result is returned itself, several in a struct of that function's name.
std::string eigen_form(const WrappedModel& model, const WrappedFunction& function) {
  std::string parameters, arguments, result, text;
  for (const WrappedArray& array : function.inputs) {
    const std::string comma = parameters.empty() ? "" : ", ";
    const std::string type = matrix_type(model, array);
    parameters += comma + (array.by_value ? type : "const " + type + "&") + " " + array.name;
    arguments += comma + argument(array, array.name);
  }
  const bool several = function.outputs.size() > 1;
  const std::string type =
      several ? function.name + "_result" : matrix_type(model, function.outputs[0]);
  if (several) {
    text += fmt::format("struct {} {{\n", type);
    for (const WrappedArray& array : function.outputs)
      text += fmt::format("  {} {};\n", matrix_type(model, array), array.name);
    text += "};\n";
  }
  for (const WrappedArray& array : function.outputs) {
    if (!arguments.empty()) arguments += ", ";
    arguments += argument(array, several ? "returned." + array.name : "returned");
  }
  return text + fmt::format(
                    "inline {0} {1}({2}) {{\n  {0} returned;\n  ::{3}_{1}({4});\n  return "
                    "returned;\n}}\n",
                    type, function.name, parameters, model.name, arguments);
}

}  // namespace

FileSet cpp_files(const WrappedModel& model) {
  std::string spans, matrices;
  for (const WrappedFunction& function : model.functions) {
    spans += span_form(model, function);
    if (!function.outputs.empty()) matrices += eigen_form(model, function);
  }
  const std::string upper = cpp_upper(model.name);
  const std::string functions =
      spans + fmt::format("\n#ifdef SINEW_{}_EIGEN\n", upper) + matrices + "#endif\n";
  FileSet files{{"sinew_" + model.name + ".hpp",
                 filled(cpp_head, model,
                        {{"UPPER", upper}, {"NAMES", cpp_names(model)}, {"FUNCTIONS", functions}})},
                {"CMakeLists.txt", filled(cpp_cmake, model)}};
  add_sources(files, model, "source/", true);
  return files;
}

}  // namespace sinew
