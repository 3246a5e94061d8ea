# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` gives besides the program: runtime, emitted models, a CMake package
# (sinew::runtime, sinew::model_<m>, sinew::model_<m>_batch) and pkg-config files (sinew, sinew_model_<m>,
# sinew_model_<m>_batch).
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/sinew)
set(header_folder ${CMAKE_INSTALL_INCLUDEDIR}/sinew)
set(template_folder ${PROJECT_SOURCE_DIR}/cmake)
set(made_folder ${PROJECT_BINARY_DIR}/package)

# From the folder of the .pc files to the prefix, so that an installed tree may be moved.
file(RELATIVE_PATH SINEW_PC_TO_PREFIX
  /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
string(REGEX REPLACE "/$" "" SINEW_PC_TO_PREFIX "${SINEW_PC_TO_PREFIX}")

file(GLOB runtime_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/runtime/*.h)
install(FILES ${runtime_headers} DESTINATION ${header_folder})
set_target_properties(sinew_runtime PROPERTIES EXPORT_NAME runtime)
install(TARGETS sinew_runtime EXPORT sinew)
list(JOIN SINEW_RUNTIME_OPTIONS " " SINEW_PC_OPTIONS)
configure_file(${template_folder}/sinew.pc.in ${made_folder}/sinew.pc @ONLY)
install(FILES ${made_folder}/sinew.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

foreach(SINEW_MODEL IN LISTS SINEW_MODELS)
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/generated/${SINEW_MODEL}/*.h)
  install(FILES ${headers} DESTINATION ${header_folder})
  install(FILES ${PROJECT_SOURCE_DIR}/generated/${SINEW_MODEL}/host/${SINEW_MODEL}_batch.h
    DESTINATION ${header_folder}/host)
  set_target_properties(sinew_model_${SINEW_MODEL} PROPERTIES EXPORT_NAME model_${SINEW_MODEL})
  install(TARGETS sinew_model_${SINEW_MODEL} EXPORT sinew
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set(SINEW_PC_CFLAGS "")
  configure_file(${template_folder}/sinew_model.pc.in ${made_folder}/sinew_model_${SINEW_MODEL}.pc @ONLY)
  # Its loops over many states, a library of their own: model_<m>_batch.
  set_target_properties(sinew_model_${SINEW_MODEL}_batch PROPERTIES
    EXPORT_NAME model_${SINEW_MODEL}_batch)
  install(TARGETS sinew_model_${SINEW_MODEL}_batch EXPORT sinew
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  set(model ${SINEW_MODEL})
  set(SINEW_MODEL ${model}_batch)
  set(SINEW_PC_CFLAGS "Cflags: -I\${prefix}/${header_folder}/host")
  configure_file(${template_folder}/sinew_model.pc.in ${made_folder}/sinew_model_${SINEW_MODEL}.pc @ONLY)
  install(FILES ${made_folder}/sinew_model_${model}.pc ${made_folder}/sinew_model_${SINEW_MODEL}.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()

# hand_step as a library, and all that runs on a board as C: firmware has a compiler of its own.
set_target_properties(sinew_hand_step PROPERTIES EXPORT_NAME hand_step)
install(TARGETS sinew_hand_step EXPORT sinew ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES ${PROJECT_SOURCE_DIR}/firmware/hand/hand_step.h
  ${PROJECT_SOURCE_DIR}/firmware/hand/hand_parameters.h DESTINATION ${header_folder})
set(SINEW_SOURCE_FOLDER ${CMAKE_INSTALL_DATADIR}/sinew)
set(SINEW_HEADER_FOLDER ${header_folder})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/firmware DESTINATION ${SINEW_SOURCE_FOLDER}
  FILES_MATCHING PATTERN "*.[chS]" PATTERN "*.ld")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/generated DESTINATION ${SINEW_SOURCE_FOLDER}
  FILES_MATCHING PATTERN "*.[ch]" PATTERN "host" EXCLUDE PATTERN "*_catalogue.*" EXCLUDE)
configure_package_config_file(${template_folder}/sinew-sources.cmake.in
  ${made_folder}/sinew-sources.cmake INSTALL_DESTINATION ${package_folder}
  PATH_VARS SINEW_SOURCE_FOLDER SINEW_HEADER_FOLDER)
install(FILES ${made_folder}/sinew-sources.cmake DESTINATION ${package_folder})

install(EXPORT sinew NAMESPACE sinew:: FILE sinew-targets.cmake DESTINATION ${package_folder})
configure_package_config_file(${template_folder}/sinew-config.cmake.in
  ${made_folder}/sinew-config.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${made_folder}/sinew-config-version.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)  # cross-compilers take its C
install(FILES ${made_folder}/sinew-config.cmake ${made_folder}/sinew-config-version.cmake
  DESTINATION ${package_folder})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/LICENSES DESTINATION ${CMAKE_INSTALL_DOCDIR})
