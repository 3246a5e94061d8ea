# SPDX-License-Identifier: GPL-3.0-or-later
# Rooms: a folder of the host program is one library, and the compiler finds the headers of the rooms
# it is linked to and of no others. An include against the direction ends the build.

# sinew_room_headers(<target> <room>): sources linked to the target include "<room>/<header>".
function(sinew_room_headers target room)
  set(root ${PROJECT_BINARY_DIR}/rooms/${target})
  get_filename_component(parent ${root}/${room} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${room} ${root}/${room} SYMBOLIC)
  target_include_directories(${target} INTERFACE ${root})
endfunction()

# sinew_add_room(<room> LINKS <target>... [PRIVATE <target>...]): library sinew_<room, / as _> of the
# sources in that folder (those below it are rooms of their own); LINKS: what its headers use.
function(sinew_add_room room)
  cmake_parse_arguments(arg "" "" "LINKS;PRIVATE" ${ARGN})
  string(REPLACE / _ target sinew_${room})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${room}/*.cpp)
  add_library(${target} STATIC ${sources})
  sinew_room_headers(${target} ${room})
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/rooms/${target})
  target_link_libraries(${target} PUBLIC ${arg_LINKS}
                        PRIVATE ${arg_PRIVATE} sinew_room_libraries sinew_warnings)
  target_precompile_headers(${target} REUSE_FROM sinew_room_precompiled)
endfunction()

# What the rooms' sources read most, precompiled once for all of them; g++ takes it only where these
# libraries' definitions hold.
file(WRITE ${PROJECT_BINARY_DIR}/rooms/precompiled.cpp "")
add_library(sinew_room_libraries INTERFACE)
target_link_libraries(sinew_room_libraries INTERFACE PkgConfig::ginac Eigen3::Eigen fmt::fmt
                      nlohmann_json::nlohmann_json Boost::headers)
add_library(sinew_room_precompiled OBJECT ${PROJECT_BINARY_DIR}/rooms/precompiled.cpp)
target_link_libraries(sinew_room_precompiled PRIVATE sinew_room_libraries sinew_warnings)
sinew_precompile(sinew_room_precompiled <ginac/ginac.h> <Eigen/Dense> <fmt/format.h> <nlohmann/json.hpp>
                 <boost/multiprecision/cpp_bin_float.hpp> <boost/multiprecision/eigen.hpp>)

# What symbolic/ hands over to the generator: generator/function.h and what that includes.
add_library(sinew_function INTERFACE)
foreach(header function.h range.h)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/rooms/sinew_function/generator)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/generator/${header}
       ${PROJECT_BINARY_DIR}/rooms/sinew_function/generator/${header} SYMBOLIC)
endforeach()
target_include_directories(sinew_function INTERFACE ${PROJECT_BINARY_DIR}/rooms/sinew_function)
target_link_libraries(sinew_function INTERFACE PkgConfig::ginac)

# The runtime's headers for programs of the host, as "runtime/<header>".
add_library(sinew_runtime_headers INTERFACE)
sinew_room_headers(sinew_runtime_headers runtime)

# The real-time step and the mailbox for programs of the host, as "firmware/<header>".
add_library(sinew_firmware_headers INTERFACE)
sinew_room_headers(sinew_firmware_headers firmware)
