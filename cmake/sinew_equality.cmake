# SPDX-License-Identifier: BSD-2-Clause
# The images of one model and the host program that computes what they are compared with.

# sinew_expected_program(<model>): builds <expected_program> with the host's compiler from the same
# sources as the images, under the same floating-point rules. Not optimised: it runs once, and that
# the host's bits are the same at every level of optimisation is a test of its own.
function(sinew_expected_program model)
  get_target_property(sources sinew_model_${model} SOURCES)
  get_target_property(folder sinew_model_${model} SOURCE_DIR)
  set(program ${CMAKE_CURRENT_BINARY_DIR}/expected_${model})
  set(own ${CMAKE_CURRENT_SOURCE_DIR}/expected_table.c ${CMAKE_CURRENT_SOURCE_DIR}/evaluation.c
    ${CMAKE_CURRENT_SOURCE_DIR}/states.c)
  file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h
    ${PROJECT_SOURCE_DIR}/runtime/*.h ${folder}/${model}/*.h)
  add_custom_command(OUTPUT ${program}
    COMMAND ${SINEW_HOST_C_COMPILER} -std=c11 -O0 ${SINEW_C_MODEL_OPTIONS} -Wall -Wextra
      -DSINEW_MODEL=${model} -I ${CMAKE_CURRENT_SOURCE_DIR} -I ${PROJECT_SOURCE_DIR}/runtime
      -I ${folder}/${model} ${own} ${sources} -o ${program}
    DEPENDS ${own} ${sources} ${headers} VERBATIM
    COMMENT "Building the host's side of the comparison of ${model}")
  set(expected_program ${program} PARENT_SCOPE)
endfunction()

# sinew_expected_table(<model> <name> [planted]): the host's results as <name>.c; with one bit turned
# where `planted` is given.
function(sinew_expected_table model name)
  add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.c
    COMMAND ${expected_program} write ${CMAKE_CURRENT_BINARY_DIR}/${name}.c
      ${SINEW_EQUALITY_STATES} ${ARGN}
    DEPENDS ${expected_program} VERBATIM
    COMMENT "Computing the host's results of ${model} (${name})")
endfunction()

function(sinew_model_image image model)
  sinew_image(${image} ${ARGN} states.c)
  target_compile_definitions(${image} PRIVATE SINEW_MODEL=${model})
  target_link_libraries(${image} PRIVATE sinew_model_${model})
endfunction()

# The model compiled with fused multiply-adds, on a core that has them: the control that shows that
# the comparison sees a wrong compiler option.
function(sinew_contracted_model model)
  get_target_property(sources sinew_model_${model} SOURCES)
  get_target_property(folder sinew_model_${model} SOURCE_DIR)
  sinew_image(contracted_${model} equality.c evaluation.c states.c
    ${CMAKE_CURRENT_BINARY_DIR}/expected_table_${model}.c ${sources})
  target_compile_definitions(contracted_${model} PRIVATE SINEW_MODEL=${model})
  target_include_directories(contracted_${model} PRIVATE ${folder}/${model}
    ${PROJECT_SOURCE_DIR}/runtime)
  get_target_property(options sinew_model_${model} SINEW_BOARD_OPTIONS)  # else 40 s for the wrist
  set_source_files_properties(${sources} PROPERTIES
    COMPILE_OPTIONS "-ffp-contract=fast;-fno-math-errno;${options}")
  sinew_image_test(contracted_${model} 1)
endfunction()

function(sinew_equality_images model)
  sinew_expected_program(${model})
  set(generated ${CMAKE_CURRENT_BINARY_DIR})
  sinew_expected_table(${model} expected_table_${model})
  sinew_model_image(equality_${model} ${model}
    equality.c evaluation.c ${generated}/expected_table_${model}.c)
  sinew_image_test(equality_${model} 0)

  # Planted defect: one bit of the host's results is turned.
  sinew_expected_table(${model} planted_table_${model} planted)
  sinew_model_image(planted_${model} ${model}
    equality.c evaluation.c ${generated}/planted_table_${model}.c)
  sinew_image_test(planted_${model} 1)
  if(SINEW_BOARD STREQUAL mps2_an500)
    sinew_contracted_model(${model})
  endif()

  sinew_model_image(control_loop_${model} ${model} control_loop.c)
  sinew_image_test(control_loop_${model} 0)

  sinew_model_image(count_${model} ${model} count.c)
  sinew_budget_test(count_${model} ${model})
endfunction()

# sinew_counted_image(<image>): an image of count.c that the emulator's plugin counts.
function(sinew_counted_image image)
  target_compile_definitions(${image} PRIVATE COUNT_STATES=${SINEW_COUNT_STATES}U)
  add_dependencies(${image} sinew_count_plugin)
endfunction()

# sinew_budget_test(<image> <model>): every function has one count at all states, and needs no more
# instructions, flash, RAM and stack than firmware/budget.csv says.
function(sinew_budget_test image model)
  sinew_counted_image(${image})
  set(test "${SINEW_BOARD}: ${model} stays within its budget")
  add_test(NAME ${test}
    COMMAND ${PROJECT_SOURCE_DIR}/tests/firmware/within_budget ${PROJECT_BINARY_DIR} ${SINEW_BOARD}
      ${model})
  # Seconds, but an emulator that shares its processor with a dozen of programs needs a minute.
  set_tests_properties(${test} PROPERTIES TIMEOUT 600 SKIP_RETURN_CODE 77
    ENVIRONMENT SINEW_BOARD_SECONDS=500)
endfunction()
