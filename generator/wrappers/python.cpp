// SPDX-License-Identifier: GPL-3.0-or-later
// A Python package: the emitted C as a shared library, called through ctypes on NumPy arrays. It is
// built by a backend of its own, so that `pip install` needs a C compiler and no network.
#include <fmt/format.h>

#include <set>

#include "generator/wrappers/template_text.h"

namespace sinew {
namespace {

const char* const python_project = R"(# SPDX-License-Identifier: BSD-2-Clause
# Made by: sinew generate (--python). Do not edit: change the model and generate again.
[build-system]
requires = []
build-backend = "sinew_build"
backend-path = ["."]

[project]
name = "sinew-@MODEL@"
version = "0.1.0"
requires-python = ">=3.8"
dependencies = ["numpy"]
)";

const char* const python_backend = R"PY(# SPDX-License-Identifier: BSD-2-Clause
"""Builds the wheel: compiles the C of source/ with the C compiler (CC, or cc) and packs it.

Nothing is fetched. The floating-point options are those under which the emitted C gives the same
bits on every machine.
"""
import base64
import glob
import hashlib
import os
import shlex
import subprocess
import sysconfig
import tarfile
import tempfile
import zipfile

MODULE = "sinew_@MODEL@"
NAME = "sinew_@MODEL@-0.1.0"
SOURCES = ["@MODEL@.c", "@MODEL@_catalogue.c", "host/@MODEL@_batch.c"]
OPTIONS = ["-std=c11", "-fPIC", "-ffp-contract=off", "-fno-math-errno", "-fno-tree-slp-vectorize",
           "-Isource"]
METADATA = """Metadata-Version: 2.1
Name: sinew-@MODEL@
Version: 0.1.0
Requires-Python: >=3.8
Requires-Dist: numpy
"""


def compile_library(path):
    """Compiles SOURCES, of the folder source/, into the shared library `path`."""
    compiler = shlex.split(os.environ.get("CC", "cc"))
    with tempfile.TemporaryDirectory() as folder:
        objects = []
        for source in SOURCES:
            made = os.path.join(folder, os.path.basename(source) + ".o")
            level = "-O3" if source.startswith("host/") else "-O2"
            run(compiler + OPTIONS + [level, "-c", "source/" + source, "-o", made])
            objects.append(made)
        run(compiler + ["-shared", "-o", path] + objects)


def run(command):
    try:
        subprocess.run(command, check=True)
    except FileNotFoundError:
        raise SystemExit(f"no C compiler: '{command[0]}' cannot be started; install gcc or clang, "
                         "or name yours in CC")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    tag = "py3-none-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")
    files = {f"{MODULE}/{os.path.basename(f)}": open(f, "rb").read()
             for f in sorted(glob.glob(f"{MODULE}/*.py") + [f"{MODULE}/py.typed"])}
    with tempfile.TemporaryDirectory() as folder:
        library = os.path.join(folder, "emitted.so")
        compile_library(library)
        files[f"{MODULE}/emitted.so"] = open(library, "rb").read()
    info = f"{NAME}.dist-info"
    files[f"{info}/METADATA"] = METADATA.encode()
    files[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: sinew\nRoot-Is-Purelib: false\n"
                              f"Tag: {tag}\n").encode()
    record = ""
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(content)}\n"
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    wheel = f"{NAME}-{tag}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, wheel), "w", zipfile.ZIP_DEFLATED) as packed:
        for name, content in files.items():
            packed.writestr(name, content)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    name = f"{NAME}.tar.gz"
    with tarfile.open(os.path.join(sdist_directory, name), "w:gz") as packed:
        for path in ["pyproject.toml", "sinew_build.py", "source", MODULE]:
            packed.add(path, f"{NAME}/{path}")
    return name
)PY";

const char* const python_library = R"PY(# SPDX-License-Identifier: BSD-2-Clause
"""The compiled model, and how NumPy arrays go into it and come out."""
import ctypes
import os
from typing import NamedTuple, Optional, Sequence, Tuple

import numpy as np

SCALAR = np.dtype("@DTYPE@")
_path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "emitted.so")
if not os.path.exists(_path):
    raise ImportError(f"{_path} is missing: install the package (pip install <its folder>), which "
                      "compiles it")
_library = ctypes.CDLL(_path)
_Pointer = ctypes.c_void_p
_Number = ctypes.c_float if SCALAR == np.float32 else ctypes.c_double


class Shape(NamedTuple):
    """Of an argument or a result; a vector has one number, a number has none."""

    name: str
    shape: Tuple[int, ...]
    by_value: bool = False  # as C takes it
    status: bool = False  # an int in C

    @property
    def size(self) -> int:
        return int(np.prod(self.shape, dtype=int))


class Function:
    """One emitted function. Leading axes of the arguments are states and are broadcast."""

    def __init__(self, name: str, inputs: Sequence[Shape], outputs: Sequence[Shape], batch: bool):
        self.name, self.inputs, self.outputs = name, inputs, outputs
        self._one = getattr(_library, name)
        self._many = getattr(_library, name + "_batch") if batch else None
        pointers = [_Pointer] * (len(inputs) + len(outputs))
        self._one.argtypes = [_Number if port.by_value else _Pointer
                              for port in [*inputs, *outputs]]
        self._one.restype = None
        if self._many is not None:
            self._many.argtypes, self._many.restype = [ctypes.c_int] + pointers, None

    def __call__(self, *arguments):
        arrays = [self._checked(a, port) for a, port in zip(arguments, self.inputs)]
        states: Tuple[int, ...] = np.broadcast_shapes(
            *[a.shape[: a.ndim - len(port.shape)] for a, port in zip(arrays, self.inputs)])
        results = self._single(arrays) if not states else self._all(arrays, states)
        return results[0] if len(results) == 1 else tuple(results)

    def _checked(self, argument, port: Shape) -> np.ndarray:
        array = np.asarray(argument, SCALAR)
        rank = len(port.shape)
        if array.ndim < rank or array.shape[array.ndim - rank:] != port.shape:
            raise ValueError(f"{self.name}: {port.name} has the shape {array.shape}; expected "
                             f"{port.shape}, or states before it")
        return array

    def _single(self, arrays):
        held = [np.ascontiguousarray(a) for a in arrays]
        results = [np.empty(port.shape, self._type(port)) for port in self.outputs]
        self._one(*[a.item() if port.by_value else a.ctypes.data
                    for a, port in zip(held, self.inputs)], *[r.ctypes.data for r in results])
        return results

    @staticmethod
    def _type(port: Shape):
        return np.dtype(np.intc) if port.status else SCALAR

    def _all(self, arrays, states):
        count = int(np.prod(states, dtype=int))
        rows = [np.broadcast_to(a, states + port.shape).reshape(count, port.size)
                for a, port in zip(arrays, self.inputs)]
        if self._many is None or count >= 2**31:
            results = self._one_after_the_other(rows, count)
        else:  # element k of state i is at [k * count + i]
            held = [np.ascontiguousarray(r.T) for r in rows]
            made = [np.empty((port.size, count), self._type(port)) for port in self.outputs]
            self._many(count, *[a.ctypes.data for a in held + made])
            results = [m.T for m in made]
        return [np.ascontiguousarray(r).reshape(states + port.shape)
                for r, port in zip(results, self.outputs)]

    def _one_after_the_other(self, rows, count):
        held = [np.ascontiguousarray(r) for r in rows]
        results = [np.empty((count, port.size), self._type(port)) for port in self.outputs]
        for state in range(count):
            self._one(*[a[state].item() if port.by_value else a[state].ctypes.data
                        for a, port in zip(held, self.inputs)],
                      *[r[state].ctypes.data for r in results])
        return results
)PY";

const char* const python_head = R"PY(# SPDX-License-Identifier: BSD-2-Clause
# Made by: sinew generate (--python). Do not edit: change the model and generate again.
"""The functions of the model @MODEL@. SI units.

Every argument may have more axes before those named: they are states, are broadcast as NumPy
broadcasts, and come back before the results' own axes.
"""
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .library import Function, Shape

)PY";

std::string python_name(const std::string& name) {
  static const std::set<std::string> words{
      "False",   "None",     "True",     "and",    "as",       "assert", "async",  "await",
      "break",   "class",    "continue", "def",    "del",      "elif",   "else",   "except",
      "finally", "for",      "from",     "global", "if",       "import", "in",     "is",
      "lambda",  "nonlocal", "not",      "or",     "pass",     "raise",  "return", "try",
      "while",   "with",     "yield",    "np",     "Function", "Shape",  "float"};
  return words.count(name) ? name + "_" : name;
}

std::string python_class(const std::string& name) {
  std::string text;
  bool upper = true;
  for (const char c : name) {
    if (c != '_')
      text += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    upper = c == '_';
  }
  return text + "Result";
}

/// The shape as NumPy has it: "(4, 4)", "(4,)", "()" of a number.
std::string python_shape(const WrappedArray& array) {
  if (array.is_scalar()) return "()";
  return array.is_vector() ? fmt::format("({},)", array.rows)
                           : fmt::format("({}, {})", array.rows, array.cols);
}

std::string python_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return quoted + "\"";
}

std::string python_names(const std::vector<std::string>& names) {
  std::string text = "(";
  for (const std::string& name : names) text += python_text(name) + ", ";
  return text + ")";
}

std::string python_ports(const std::vector<WrappedArray>& arrays) {
  std::string text = "(";
  for (const WrappedArray& array : arrays)
    text += fmt::format("Shape(\"{}\", {}{}{}), ", array.name, python_shape(array),
                        array.by_value ? ", by_value=True" : "",
                        array.is_status() ? ", status=True" : "");
  return text + ")";
}

std::string python_described(const WrappedArray& array) {
  std::string text = python_shape(array);
  if (!array.unit.empty()) text += " [" + array.unit + "]";
  if (!array.doc.empty()) text += " " + array.doc;
  if (array.order == "joints_and_wrist") return text + ", in the order of JOINTS + WRIST";
  std::string list = array.order;
  for (char& c : list) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return list.empty() ? text : text + ", in the order of " + list;
}

std::string python_docstring(const WrappedFunction& function) {
  std::string text = fmt::format("    \"\"\"{}{}\n\n", function.doc,
                                 function.equation.empty() ? "" : " " + function.equation);
  for (const WrappedArray& array : function.inputs)
    text += fmt::format("    {}: {}\n", python_name(array.name), python_described(array));
  text += function.outputs.size() == 1 ? "\n    Returns " : "\n    Returns a tuple of\n";
  for (const WrappedArray& array : function.outputs)
    text += fmt::format("{}{}: {}\n", function.outputs.size() == 1 ? "" : "    ", array.name,
                        python_described(array));
  return text + "    \"\"\"\n";
}

std::string python_type(const WrappedModel& model, const WrappedArray& array) {
  if (array.is_status()) return "NDArray[np.intc]";
  return fmt::format("NDArray[np.{}]", model.scalar == "float" ? "float32" : "float64");
}

/// Several results come back by name.
std::string python_result(const WrappedModel& model, const WrappedFunction& function) {
  std::string text = fmt::format("\n\nclass {}(NamedTuple):\n    \"\"\"Of {}.\"\"\"\n\n",
                                 python_class(function.name), function.name);
  for (const WrappedArray& array : function.outputs)
    text += fmt::format("    {}: {}\n", python_name(array.name), python_type(model, array));
  return text;
}

std::string python_function(const WrappedModel& model, const WrappedFunction& function) {
  const bool several = function.outputs.size() > 1;
  std::string parameters, arguments, text;
  for (const WrappedArray& array : function.inputs) {
    const std::string comma = parameters.empty() ? "" : ", ";
    parameters += comma + python_name(array.name) + ": ArrayLike";
    arguments += comma + python_name(array.name);
  }
  if (several) text += python_result(model, function);
  text += fmt::format("\n\n_{0} = Function(\"{1}_{0}\", {2}, {3}, {4})\n\n\n", function.name,
                      model.name, python_ports(function.inputs), python_ports(function.outputs),
                      function.has_batch ? "True" : "False");
  text += fmt::format("def {}({}) -> {}:\n{}", python_name(function.name), parameters,
                      several                    ? python_class(function.name)
                      : function.outputs.empty() ? std::string("None")
                                                 : python_type(model, function.outputs.front()),
                      python_docstring(function));
  const std::string call = fmt::format("_{}({})", function.name, arguments);
  return text + (several ? fmt::format("    return {}(*{})\n", python_class(function.name), call)
                         : fmt::format("    return {}\n", call));
}

std::string python_init(const WrappedModel& model) {
  std::vector<std::string> joints, units;
  std::string low, high, functions, exported;
  for (const WrappedJoint& joint : model.joints) {
    joints.push_back(joint.name);
    units.push_back(joint.unit);
    low += number_text(joint.low) + ", ";
    high += number_text(joint.high) + ", ";
  }
  for (const WrappedFunction& function : model.functions) {
    functions += fmt::format("    {},\n", python_name(function.name));
    exported += fmt::format("    \"{}\",\n", python_name(function.name));
  }
  return filled(R"PY(# SPDX-License-Identifier: BSD-2-Clause
# Made by: sinew generate (--python). Do not edit: change the model and generate again.
"""@DESCRIPTION@

JOINTS, TENDONS and FRAMES are the names of the arrays' elements, in order. LOW and HIGH are the
ranges of the joints [rad, or m where a joint slides].
"""
import numpy as np

from .functions import (
@FUNCTIONS@)

MODEL = "@MODEL@"
SHA256 = "@HASH@"
JOINTS = @JOINTS@
JOINT_UNITS = @UNITS@
TENDONS = @TENDONS@
FRAMES = @FRAMES@
WRIST = @WRIST@
LOW = np.array([@LOW@])
HIGH = np.array([@HIGH@])

__all__ = [
@EXPORTED@    "FRAMES",
    "HIGH",
    "JOINTS",
    "JOINT_UNITS",
    "LOW",
    "MODEL",
    "SHA256",
    "TENDONS",
    "WRIST",
]
)PY",
                model,
                {{"FUNCTIONS", functions},
                 {"EXPORTED", exported},
                 {"JOINTS", python_names(joints)},
                 {"UNITS", python_names(units)},
                 {"TENDONS", python_names(model.tendons)},
                 {"FRAMES", python_names(model.frames)},
                 {"WRIST", python_names(model.wrist)},
                 {"LOW", low},
                 {"HIGH", high}});
}

}  // namespace

FileSet python_files(const WrappedModel& model) {
  const std::string module = "sinew_" + model.name + "/";
  std::string functions = filled(python_head, model);
  for (const WrappedFunction& function : model.functions)
    functions += python_function(model, function);
  FileSet files{
      {"pyproject.toml", filled(python_project, model)},
      {"sinew_build.py", filled(python_backend, model)},
      {module + "__init__.py", python_init(model)},
      {module + "library.py",
       filled(python_library, model, {{"DTYPE", model.scalar == "float" ? "float32" : "float64"}})},
      {module + "functions.py", functions},
      {module + "py.typed", ""}};
  add_sources(files, model, "source/", true);
  return files;
}

}  // namespace sinew
