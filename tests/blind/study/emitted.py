# SPDX-License-Identifier: GPL-3.0-or-later
"""Emitted C, compiled and called by its catalogue."""
import array
import ctypes
import pathlib
import subprocess

from filters import loops, pointer


class Argument(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("unit", ctypes.c_char_p), ("rows", ctypes.c_int),
                ("cols", ctypes.c_int), ("low", ctypes.POINTER(ctypes.c_double)),
                ("high", ctypes.POINTER(ctypes.c_double))]


class Function(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("input_count", ctypes.c_int), ("output_count", ctypes.c_int),
                ("input_size", ctypes.c_int), ("output_size", ctypes.c_int),
                ("inputs", ctypes.POINTER(Argument)), ("outputs", ctypes.POINTER(Argument)),
                ("call", ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p))]


class Catalogue(ctypes.Structure):
    _fields_ = [("model", ctypes.c_char_p), ("hash", ctypes.c_char_p), ("scalar_bytes", ctypes.c_int),
                ("function_count", ctypes.c_int), ("functions", ctypes.POINTER(Function))]


class Emitted:
    """The C in a folder that `sinew generate` or `sinew diagnose` wrote."""

    def __init__(self, folder, runtime):
        folder = pathlib.Path(folder)
        self.model = next(folder.glob("*_catalogue.c")).name.removesuffix("_catalogue.c")
        library = folder / "trial.so"
        sources = [folder / f"{self.model}.c", folder / f"{self.model}_catalogue.c"]
        subprocess.run(["cc", "-std=c11", "-O0", "-shared", "-fPIC", "-ffp-contract=off", "-fno-math-errno",
                        "-I", runtime, "-I", folder, *sources, "-o", library, "-lm"], check=True,
                       capture_output=True)
        self.library = ctypes.CDLL(str(library.resolve()))
        catalogue = Catalogue.in_dll(self.library, f"{self.model}_catalogue")
        self.functions = {catalogue.functions[i].name.decode().removeprefix(self.model + "_"): catalogue.functions[i]
                          for i in range(catalogue.function_count)}

    def inputs(self, function):
        f = self.functions[function]
        return [(f.inputs[i].name.decode(), f.inputs[i].rows * f.inputs[i].cols)
                for i in range(f.input_count)]

    def ranges(self, function, argument):
        f = self.functions[function]
        for i in range(f.input_count):
            a = f.inputs[i]
            if a.name.decode() == argument:
                return [(a.low[k], a.high[k]) for k in range(a.rows * a.cols)]
        raise KeyError(argument)

    def caller(self, function):
        """A function from a flat list of inputs to a list of results."""
        f = self.functions[function]
        given, result = (ctypes.c_double * f.input_size)(), (ctypes.c_double * f.output_size)()
        at_in, at_out = ctypes.addressof(given), ctypes.addressof(result)

        def call(values):
            given[:] = values
            f.call(at_in, at_out)
            return list(result)
        return call

    def offsets(self, function):
        """name -> (first input, numbers), and the same of results."""
        f, result = self.functions[function], []
        for list_, count in ((f.inputs, f.input_count), (f.outputs, f.output_count)):
            at, places = 0, {}
            for i in range(count):
                size = list_[i].rows * list_[i].cols
                places[list_[i].name.decode()] = (at, size)
                at += size
            result.append(places)
        return result

    def columns(self, function, output):
        f = self.functions[function]
        return next(f.outputs[i].cols for i in range(f.output_count) if f.outputs[i].name.decode() == output)

    def rows(self, function, signals, constants=None):
        """Results, a list of columns, of every row of a log. signals: name -> columns; constants: name -> number.
        What the function keeps ("memory", from "next") goes on from row to row; what is not given is zero."""
        f, (inputs, outputs) = self.functions[function], self.offsets(function)
        count = len(next(iter(signals.values()))[0])
        given = array.array("d", bytes(8 * count * f.input_size))
        said = array.array("d", bytes(8 * count * f.output_size))
        for name, (at, size) in inputs.items():
            if name in signals:
                if len(signals[name]) != size:
                    raise ValueError(f"{function} takes {size} columns of '{name}', the log has {len(signals[name])}")
                for i, column in enumerate(signals[name]):
                    given[at + i::f.input_size] = array.array("d", column)
            elif constants and name in constants:
                for i in range(size):
                    given[at + i::f.input_size] = array.array("d", [constants[name]]) * count
            elif name != "memory":
                raise ValueError(f"{function} takes '{name}', which the log has not")
        memory, kept = inputs.get("memory", (0, 0))
        loops().played(ctypes.cast(f.call, ctypes.c_void_p), count, pointer(given), f.input_size, pointer(said),
                       f.output_size, memory, outputs.get("next", (0, 0))[0], kept)
        return [said[i::f.output_size] for i in range(f.output_size)]
