# SPDX-License-Identifier: GPL-3.0-or-later
# The project's warning level and the floating-point rules of emitted C.
option(SINEW_WERROR "Treat warnings as errors" ON)
option(SINEW_SANITIZE "Address and undefined-behaviour sanitizers" OFF)

# GCC before 13 takes optimised std::string operations for overlapping copies (its bug 105651), and,
# where the standard library's headers come precompiled, for copies without end. The preset dev,
# which precompiles none, keeps the second warning.
set(false_copies -Wno-restrict)
if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
  list(APPEND false_copies -Wno-stringop-overflow -Wno-array-bounds -Wno-stringop-overread)
endif()
set(gcc_before_13 "$<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>")

add_library(sinew_warnings INTERFACE)
target_compile_options(sinew_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion
  "$<${gcc_before_13}:${false_copies}>"
  $<$<BOOL:${SINEW_WERROR}>:-Werror>)
if(SINEW_SANITIZE)
  target_compile_options(sinew_warnings INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer)
  target_link_options(sinew_warnings INTERFACE -fsanitize=address,undefined)
endif()

# Emitted C must give the same bits everywhere: no fused multiply-add unless asked for,
# and a square root that is one instruction instead of a call that may set errno.
set(SINEW_C_MODEL_OPTIONS -ffp-contract=off -fno-math-errno)
