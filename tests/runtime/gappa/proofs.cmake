# SPDX-License-Identifier: GPL-3.0-or-later
# Fills in the proof scripts with the coefficients that stand in runtime/ and runs gappa on them:
# a changed coefficient is a changed proof.

# a1 + x * (a2 + x * (...)) in <result>
function(nested result variable)
  list(REVERSE ARGN)
  list(POP_FRONT ARGN text)
  foreach(factor IN LISTS ARGN)
    set(text "${factor} + ${variable} * (${text})")
  endforeach()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# sinew_kernel_proof(<name> <sine|cosine> <double|float> low high tail distance bound cuts): proves
# |computed - true| <= bound for low <= r <= high and |tail| <= tail.
function(sinew_kernel_proof name kernel precision LOW HIGH TAIL DISTANCE BOUND CUTS)
  set(FORMAT ieee_64)
  if(precision STREQUAL float)
    set(FORMAT ieee_32)
  endif()
  set(letter S)
  if(kernel STREQUAL cosine)
    set(letter C)
  endif()
  set(parameters ${PROJECT_SOURCE_DIR}/runtime/sinew_${precision}.h)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${parameters})
  file(STRINGS ${parameters} lines REGEX "^#define SINEW_${letter}[0-9] ")
  set(names "")
  set(VALUES "")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "#define SINEW_([SC][0-9]) ([^F]*)F?$" "\\1 = \\2;\n" assignment "${line}")
    string(APPEND VALUES "${assignment}")
    string(REGEX MATCH "[SC][0-9]" coefficient "${line}")
    list(APPEND names ${coefficient})
  endforeach()
  nested(POLYNOMIAL z ${names})
  nested(EXACT_POLYNOMIAL ze ${names})
  set(script ${CMAKE_CURRENT_BINARY_DIR}/gappa/${name}.g)
  configure_file(${CMAKE_CURRENT_SOURCE_DIR}/gappa/${kernel}.g.in ${script} @ONLY)
  add_test(NAME "runtime: gappa ${name}" COMMAND ${SINEW_GAPPA} ${script})
  set_tests_properties("runtime: gappa ${name}" PROPERTIES TIMEOUT 300
    FAIL_REGULAR_EXPRESSION "[Ee]rror;[Ww]arning;not satisfied")
endfunction()

set(top "(0.53,0.55,0.57,0.59,0.61,0.63,0.65,0.67,0.69,0.71,0.73,0.75,0.77)")
set(half "(0.505,0.51,0.515,0.52,0.522,0.523,0.5233,0.5235,0.52355,0.52358)")
set(near_half "(0.26,0.28,0.3,0.32,0.34,0.36,0.38,0.4,0.42,0.44,0.46,0.48,0.49)")
set(quarter "(0.251,0.252,0.2525,0.2526,0.25265,0.25267)")
set(below_quarter "(0.13,0.14,0.16,0.18,0.2,0.22,0.24)")
set(whole "(1e-7,1e-6,1e-5,1e-4,1e-3,0.01,0.05,0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.72,0.74,0.76)")

# Bounds: 0.85, 0.77, 0.68, 0.59 and 0.59 ulp of the result; tails are half an ulp of r. Distances as in kernel_distance.cpp.
sinew_kernel_proof(sine_1 sine double 0.52359 0.7854 1b-54 9b-61 0x1.af0p-54 "${top}")
sinew_kernel_proof(sine_2 sine double 0.5 0.52359 1b-54 1b-58 0x1.858p-55 "${half}")
sinew_kernel_proof(sine_3 sine double 0.25268 0.5 1b-55 9b-62 0x1.5c2p-55 "${near_half}")
sinew_kernel_proof(sine_4 sine double 0.25 0.25268 1b-55 1b-60 0x1.2e0p-56 "${quarter}")
sinew_kernel_proof(sine_5 sine double 0.12533 0.25 1b-56 9b-63 0x1.290p-56 "${below_quarter}")
# 0.88 ulp
sinew_kernel_proof(cosine cosine double 3e-8 0.7854 1b-54 7b-60 0x1.c28p-54 "${whole}")

# Float: 0.87, 0.82, 0.70 and 0.88 ulp.
sinew_kernel_proof(sine_float_1 sine float 0.52359 0.7854 1b-25 15b-32 0x1.b86p-25 "${top}")
sinew_kernel_proof(sine_float_2 sine float 0.5 0.52359 1b-25 1b-28 0x1.a3cp-26 "${half}")
sinew_kernel_proof(sine_float_3 sine float 0.25268 0.5 1b-26 1b-29 0x1.667p-26 "${near_half}")
sinew_kernel_proof(cosine_float cosine float 0.001 0.7854 1b-25 7b-31 0x1.c28p-25 "${whole}")

# Control: a bound that is too small must not be proved.
sinew_kernel_proof(too_small_a_bound sine double 0.75 0.7854 1b-54 9b-61 0x1.0p-54 "(0.77)")
set_tests_properties("runtime: gappa too_small_a_bound" PROPERTIES WILL_FAIL TRUE)
