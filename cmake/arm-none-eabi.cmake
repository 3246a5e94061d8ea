# SPDX-License-Identifier: BSD-2-Clause
# Toolchain of every bare-metal board; SINEW_BOARD, given by the preset, names the board.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SINEW_BOARD)
# Archives and objects of the host must never be found.
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)

# With caches and memory protection off, the A and R profiles fault on unaligned access.
set(core_zynq_a9 "-mcpu=cortex-a9 -mfpu=neon-vfpv3 -mno-unaligned-access")
set(core_mps2_an500 "-mcpu=cortex-m7 -mfpu=fpv5-d16")
set(core_zcu102_r5 "-mcpu=cortex-r5 -mfpu=vfpv3-d16 -mno-unaligned-access")
if(NOT DEFINED core_${SINEW_BOARD})
  message(FATAL_ERROR
    "SINEW_BOARD is '${SINEW_BOARD}'; expected zynq_a9, mps2_an500 or zcu102_r5 (a preset sets it)")
endif()
set(core "${core_${SINEW_BOARD}} -mfloat-abi=hard -mthumb")
set(CMAKE_C_FLAGS_INIT "${core} -ffp-contract=off -ffunction-sections -fdata-sections")
set(CMAKE_CXX_FLAGS_INIT "${core}")
set(CMAKE_ASM_FLAGS_INIT "${core}")
set(CMAKE_C_FLAGS_RELEASE "-O2 -g -DNDEBUG" CACHE STRING "Flags of the images")
