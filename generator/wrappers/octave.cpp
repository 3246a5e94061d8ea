// SPDX-License-Identifier: GPL-3.0-or-later
// A MEX gateway for Octave and MATLAB: one C file over the model's catalogue, and a package folder
// with one documented .m file a function.
#include <fmt/format.h>

#include "generator/wrappers/template_text.h"

namespace sinew {
namespace {

const char* const gateway = R"C(/* SPDX-License-Identifier: BSD-2-Clause
 *
 * [r1, r2, ...] = sinew_@MODEL@_mex('name', a1, a2, ...): a function of the model @MODEL@.
 * Matrices are Octave's, column-major, and are turned here. A last axis more is one of states: a
 * vector of n elements given as n x N, a matrix as r x c x N; results come back alike.
 *
 * Made by: sinew generate (--octave). Do not edit: change the model and generate again.
 */
#include <stdlib.h>
#include <string.h>

#include "mex.h"
#include "@MODEL@_catalogue.h"

typedef @SCALAR@ scalar;

static const sinew_function *function_named(const char *name)
{
    const size_t prefix = sizeof("@MODEL@_") - 1;
    for (int i = 0; i < @MODEL@_catalogue.function_count; ++i)
        if (strcmp(@MODEL@_catalogue.functions[i].name + prefix, name) == 0)
            return &@MODEL@_catalogue.functions[i];
    return 0;
}

static size_t size_of(const sinew_argument *port)
{
    return (size_t)port->rows * (size_t)port->cols;
}

/* States that an argument holds; ends with an error where its shape is another. */
static size_t states_of(const mxArray *array, const sinew_argument *port)
{
    const size_t all = mxGetNumberOfElements(array);
    const int is_row = port->cols == 1 && mxGetM(array) == 1 && all == size_of(port);
    if (!mxIsDouble(array) || mxIsComplex(array) || all == 0 || all % size_of(port) != 0 ||
        ((int)mxGetM(array) != port->rows && !is_row))
        mexErrMsgIdAndTxt("sinew:shape", "%s: expected %d x %d real numbers, or that and states",
                          port->name, port->rows, port->cols);
    return all / size_of(port);
}

/* Element (row, col) of state number `state` in Octave's order. */
static size_t place(const sinew_argument *port, size_t state, int row, int col)
{
    return state * size_of(port) + (size_t)col * (size_t)port->rows + (size_t)row;
}

static void take(const mxArray *array, const sinew_argument *port, size_t state, scalar *to)
{
    const double *from = mxGetPr(array);
    for (int row = 0; row < port->rows; ++row)
        for (int col = 0; col < port->cols; ++col)
            *to++ = (scalar)from[place(port, state, row, col)];
}

static void give(const scalar *from, const sinew_argument *port, size_t state, mxArray *array)
{
    double *to = mxGetPr(array);
    for (int row = 0; row < port->rows; ++row)
        for (int col = 0; col < port->cols; ++col)
            to[place(port, state, row, col)] = (double)*from++;
}

static mxArray *result_array(const sinew_argument *port, size_t states)
{
    mwSize shape[3];
    shape[0] = (mwSize)port->rows;
    shape[1] = (mwSize)(port->cols == 1 ? states : (size_t)port->cols);
    shape[2] = (mwSize)states;
    return mxCreateNumericArray(port->cols == 1 ? 2 : 3, shape, mxDOUBLE_CLASS, mxREAL);
}

static void run(const sinew_function *f, size_t states, mxArray *results[], const mxArray *given[],
                const size_t given_states[])
{
    scalar *in = mxCalloc((size_t)f->input_size + 1, sizeof(scalar));
    scalar *out = mxCalloc((size_t)f->output_size + 1, sizeof(scalar));
    for (size_t state = 0; state < states; ++state) {
        size_t at = 0;
        for (int i = 0; i < f->input_count; at += size_of(&f->inputs[i]), ++i)
            take(given[i], &f->inputs[i], given_states[i] == 1 ? 0 : state, in + at);
        f->call(in, out);
        at = 0;
        for (int i = 0; i < f->output_count; at += size_of(&f->outputs[i]), ++i)
            give(out + at, &f->outputs[i], state, results[i]);
    }
    mxFree(in);
    mxFree(out);
}

void mexFunction(int result_count, mxArray *results[], int given_count, const mxArray *given[])
{
    char name[256] = "";
    mxArray *all[64];
    size_t given_states[64], states = 1;
    if (given_count < 1 || mxGetString(given[0], name, sizeof name) != 0 || !function_named(name))
        mexErrMsgIdAndTxt("sinew:name", "the model @MODEL@ has no function '%s'", name);
    const sinew_function *f = function_named(name);
    if (given_count - 1 != f->input_count)
        mexErrMsgIdAndTxt("sinew:arguments", "%s takes %d arguments", name, f->input_count);
    if (f->input_count > 64 || f->output_count > 64)
        mexErrMsgIdAndTxt("sinew:arguments", "%s has too many arguments for the gateway", name);
    for (int i = 0; i < f->input_count; ++i) {
        given_states[i] = states_of(given[i + 1], &f->inputs[i]);
        if (given_states[i] != 1 && states != 1 && given_states[i] != states)
            mexErrMsgIdAndTxt("sinew:shape", "%s: arguments of different numbers of states", name);
        if (given_states[i] != 1) states = given_states[i];
    }
    for (int i = 0; i < f->output_count; ++i) all[i] = result_array(&f->outputs[i], states);
    run(f, states, all, given + 1, given_states);
    for (int i = 0; i < f->output_count; ++i) {
        if (i == 0 || i < result_count) results[i] = all[i];
        else mxDestroyArray(all[i]);
    }
}
)C";

const char* const octave_build = R"M(% SPDX-License-Identifier: BSD-2-Clause
% build_sinew_@MODEL@: compiles the gateway, in Octave or MATLAB. Then add this folder to the path.
function build_sinew_@MODEL@()
  here = fileparts(mfilename('fullpath'));
  source = fullfile(here, 'source');
  names = {'@MODEL@.c', '@MODEL@_catalogue.c'};
  files = cellfun(@(name) fullfile(source, name), names, 'UniformOutput', false);
  files = [{fullfile(here, 'sinew_@MODEL@_mex.c')}, files];
  % Under these options the emitted C gives the same bits on every machine.
  options = '-std=c11 -O2 -fPIC -ffp-contract=off -fno-math-errno -fno-tree-slp-vectorize';
  output = fullfile(here, ['sinew_@MODEL@_mex.' mexext()]);
  if exist('OCTAVE_VERSION', 'builtin')
    setenv('CFLAGS', options);
    status = mkoctfile('--mex', ['-I' source], '-o', output, files{:});
    if status ~= 0
      error('sinew:build', 'the gateway was not compiled');
    end
  else
    mex(['CFLAGS=' options], ['-I' source], '-output', output, files{:});
  end
end
)M";

std::string result_list(const WrappedFunction& function) {
  std::string text;
  for (const WrappedArray& array : function.outputs)
    text += (text.empty() ? "" : ", ") + array.name + "_out";
  return text;
}

/// Arguments and results may have one name, so results end with _out.
std::string m_function(const WrappedModel& model, const WrappedFunction& function) {
  std::string inputs, text;
  for (const WrappedArray& array : function.inputs)
    inputs += (inputs.empty() ? "" : ", ") + array.name;
  text = "% SPDX-License-Identifier: BSD-2-Clause\n";
  text += fmt::format("function [{}] = {}({})\n", result_list(function), function.name, inputs);
  text += fmt::format("  % {}{}\n", function.doc,
                      function.equation.empty() ? "" : " " + function.equation);
  for (const WrappedArray& array : function.inputs)
    text += fmt::format("  %   in  {}: {}\n", array.name, array_text(array));
  for (const WrappedArray& array : function.outputs)
    text += fmt::format("  %   out {}_out: {}\n", array.name, array_text(array));
  return text + fmt::format("  [{}] = sinew_{}_mex('{}'{}{});\nend\n", result_list(function),
                            model.name, function.name, inputs.empty() ? "" : ", ", inputs);
}

std::string m_names(const WrappedModel& model) {
  const auto list = [](const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
    return "{{" + text + "}}";
  };
  std::vector<std::string> joints;
  for (const WrappedJoint& joint : model.joints) joints.push_back(joint.name);
  return fmt::format(
      "% SPDX-License-Identifier: BSD-2-Clause\nfunction n = names()\n"
      "  % Names of the elements of arrays, in order, and the model's hash.\n"
      "  n = struct('joints', {}, 'tendons', {}, 'frames', {}, 'sha256', '{}');\nend\n",
      list(joints), list(model.tendons), list(model.frames), model.hash);
}

}  // namespace

FileSet octave_files(const WrappedModel& model) {
  const std::string folder = "+sinew_" + model.name + "/";
  FileSet files{{"sinew_" + model.name + "_mex.c", filled(gateway, model)},
                {"build_sinew_" + model.name + ".m", filled(octave_build, model)},
                {folder + "names.m", m_names(model)}};
  for (const WrappedFunction& function : model.functions)
    files[folder + function.name + ".m"] = m_function(model, function);
  add_sources(files, model, "source/", false);
  return files;
}

}  // namespace sinew
