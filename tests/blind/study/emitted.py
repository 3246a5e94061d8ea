# SPDX-License-Identifier: GPL-3.0-or-later
"""Emitted C, compiled and called by its catalogue."""
import ctypes
import pathlib
import subprocess


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
        subprocess.run(["cc", "-std=c11", "-O1", "-shared", "-fPIC", "-ffp-contract=off", "-fno-math-errno",
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
