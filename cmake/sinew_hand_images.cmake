# SPDX-License-Identifier: BSD-2-Clause
# The images with hand_step in them: the comparison with the host, the count of instructions, and the
# program of the real-time computer. What the models need is in sinew_equality.cmake.
set(hand_folder ${CMAKE_CURRENT_SOURCE_DIR}/hand)
set(hand_catalogue ${CMAKE_CURRENT_SOURCE_DIR}/hand_step_catalogue.c)

# The host's side, from the same sources under the same floating-point rules.
file(GLOB host_sources CONFIGURE_DEPENDS ${hand_folder}/*.c)
set(host_folders ${CMAKE_CURRENT_SOURCE_DIR} ${hand_folder} ${PROJECT_SOURCE_DIR}/runtime)
foreach(model hand thumb index middle ring fifth hmc motor)
  list(APPEND host_sources ${PROJECT_SOURCE_DIR}/generated/${model}/${model}.c)
  list(APPEND host_folders ${PROJECT_SOURCE_DIR}/generated/${model})
endforeach()
list(TRANSFORM host_folders PREPEND -I)
list(APPEND host_sources ${PROJECT_SOURCE_DIR}/generated/hand_step/hand_parameters.c
  ${hand_catalogue} ${CMAKE_CURRENT_SOURCE_DIR}/expected_table.c
  ${CMAKE_CURRENT_SOURCE_DIR}/evaluation.c ${CMAKE_CURRENT_SOURCE_DIR}/states.c)
file(GLOB host_headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h ${hand_folder}/*.h
  ${PROJECT_SOURCE_DIR}/runtime/*.h)
set(expected_program ${CMAKE_CURRENT_BINARY_DIR}/expected_hand_step)
add_custom_command(OUTPUT ${expected_program}
  COMMAND ${SINEW_HOST_C_COMPILER} -std=c11 -O0 ${SINEW_C_MODEL_OPTIONS} -Wall -Wextra
    -DSINEW_MODEL=hand_step ${host_folders} ${host_sources} -o ${expected_program}
  DEPENDS ${host_sources} ${host_headers} VERBATIM
  COMMENT "Building the host's side of the comparison of hand_step")
sinew_expected_table(hand_step expected_table_hand_step)
sinew_expected_table(hand_step planted_table_hand_step planted)

# sinew_hand_image(<image> <sources>...): an image with hand_step behind the catalogue.
function(sinew_hand_image image)
  sinew_image(${image} ${ARGN} states.c ${hand_catalogue})
  target_compile_definitions(${image} PRIVATE SINEW_MODEL=hand_step)
  target_link_libraries(${image} PRIVATE sinew_hand_step)
endfunction()

sinew_hand_image(equality_hand_step equality.c evaluation.c
  ${CMAKE_CURRENT_BINARY_DIR}/expected_table_hand_step.c)
sinew_image_test(equality_hand_step 0)
sinew_hand_image(planted_hand_step equality.c evaluation.c
  ${CMAKE_CURRENT_BINARY_DIR}/planted_table_hand_step.c)
sinew_image_test(planted_hand_step 1)

# hand_step branches on what its sensors do: its count is a range, whose end is what counts.
sinew_hand_image(count_hand_step count.c)
target_compile_definitions(count_hand_step PRIVATE HAND_STEP_RUNNING)
sinew_budget_test(count_hand_step hand_step)

sinew_image(hand_main hand_main.c)
target_link_libraries(hand_main PRIVATE sinew_hand_loop)
# Without the other side there is no mailbox: it says so and ends.
sinew_image_test(hand_main 2)

# Of the three emulated boards one has a watchdog that resets (docs/firmware.md).
if(SINEW_BOARD STREQUAL mps2_an500)
  sinew_image(watchdog watchdog.c)
  sinew_image_test(watchdog 0)
endif()

# Nobody writes frames: the board says so by its own timer, and its torques are 0.
set(test "${SINEW_BOARD}: frames that do not come are late")
add_test(NAME ${test} COMMAND ${PROJECT_SOURCE_DIR}/tests/firmware/late_frames ${SINEW_BOARD}
  $<TARGET_FILE:hand_main>)
set_tests_properties(${test} PROPERTIES TIMEOUT 120)

set(test "${SINEW_BOARD}: the board waits for an FPGA's side that is slow")
add_test(NAME ${test} COMMAND ${PROJECT_SOURCE_DIR}/tests/firmware/slow_side ${SINEW_BOARD}
  $<TARGET_FILE:hand_main>)
set_tests_properties(${test} PROPERTIES TIMEOUT 300)

# A simulated hand behind the mailbox; the program is that of the host's build.
foreach(kind short.toml real_time.toml)
  set(test "${SINEW_BOARD}: the hand moves under the board, ${kind}")
  set(scenario ${PROJECT_SOURCE_DIR}/tests/firmware/scenarios/${kind})
  if(kind STREQUAL real_time.toml)
    set(scenario ${PROJECT_SOURCE_DIR}/models/hand/scenarios/${kind})
  endif()
  add_test(NAME ${test}
    COMMAND ${PROJECT_SOURCE_DIR}/tests/firmware/board_loop ${SINEW_BOARD} $<TARGET_FILE:hand_main>
      ${PROJECT_SOURCE_DIR}/build/release/cli/sinew_fpga_side ${scenario}
      ${CMAKE_CURRENT_BINARY_DIR}/${kind}.csv)
  # Half a minute each, of which the most is the simulated hand being compiled.
  set_tests_properties(${test} PROPERTIES TIMEOUT 600 SKIP_RETURN_CODE 77 LABELS "slow;thorough")
endforeach()

# An effect hidden in that hand is found from the board's own log.
set(test "${SINEW_BOARD}: hidden friction is named from the board's log")
add_test(NAME ${test}
  COMMAND ${PROJECT_SOURCE_DIR}/tests/firmware/hidden_effect ${SINEW_BOARD} $<TARGET_FILE:hand_main>
    ${PROJECT_SOURCE_DIR}/build/release/cli/sinew_fpga_side
    ${PROJECT_SOURCE_DIR}/build/release/cli/sinew ${CMAKE_CURRENT_BINARY_DIR}/hidden_effect)
# Minutes: four runs of a second under the emulator, two diagnoses.
set_tests_properties(${test} PROPERTIES TIMEOUT 3000 SKIP_RETURN_CODE 77 LABELS "slow;thorough")
