# SPDX-License-Identifier: GPL-3.0-or-later
# The project's warning level and the floating-point rules of emitted C.
option(SINEW_WERROR "Treat warnings as errors" ON)
option(SINEW_SANITIZE "Address and undefined-behaviour sanitizers" OFF)

# GCC before 13 takes optimised std::string operations for overlapping copies (its bug 105651).
set(false_restrict "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>")

add_library(sinew_warnings INTERFACE)
target_compile_options(sinew_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion
  # gcc 12 reports string concatenation as overlapping memcpy (its bug 105651)
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<COMPILE_LANGUAGE:CXX>:${false_restrict}>
  $<$<BOOL:${SINEW_WERROR}>:-Werror>)
if(SINEW_SANITIZE)
  target_compile_options(sinew_warnings INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer)
  target_link_options(sinew_warnings INTERFACE -fsanitize=address,undefined)
endif()

# Emitted C must give the same bits everywhere: no fused multiply-add unless asked for,
# and a square root that is one instruction instead of a call that may set errno.
set(SINEW_C_MODEL_OPTIONS -ffp-contract=off -fno-math-errno)
