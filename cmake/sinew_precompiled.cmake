# SPDX-License-Identifier: GPL-3.0-or-later
# The headers of the libraries used everywhere are read once per target instead of once per source:
# reading GiNaC, Eigen and Catch2 is most of the work of compiling a source. The preset dev builds
# without (CMAKE_DISABLE_PRECOMPILE_HEADERS), so that a source that forgot an include is found.

# sinew_precompile(<target> [<header> ...]): the standard library's usual headers and those named.
function(sinew_precompile target)
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <limits> <map> <memory> <numeric>
    <optional> <set> <sstream> <stdexcept> <string> <string_view> <vector> ${ARGN})
endfunction()
