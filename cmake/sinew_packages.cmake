# SPDX-License-Identifier: GPL-3.0-or-later
# Debian packages by CPack (`cpack -G DEB` in the build folder): sinew, the program, which links
# GiNaC (GPL), and libsinew-runtime-dev, what goes into firmware and users' builds (BSD).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The sinew project")
set(CPACK_PACKAGE_CONTACT "The sinew project <sinew@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL sinew runtime)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "")

set(CPACK_DEBIAN_SINEW_PACKAGE_NAME sinew)
set(CPACK_DEBIAN_SINEW_PACKAGE_SECTION science)
# What simulation and diagnosis compile is C with the runtime's headers.
set(CPACK_DEBIAN_SINEW_PACKAGE_DEPENDS "libsinew-runtime-dev (= ${PROJECT_VERSION}), gcc | c-compiler")
set(CPACK_DEBIAN_SINEW_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_SINEW_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_SINEW_DESCRIPTION
  "Derives models of tendon-driven hands and of robots in URDF, emits them as C, simulates with
 that C, and diagnoses measured logs.")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libsinew-runtime-dev)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "Headers that the C emitted by sinew needs, the shipped models as libraries, and the CMake package
 and pkg-config files for using them.")

# Each package's licence, where Debian looks for it.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSES/GPL-3.0-or-later.txt RENAME copyright
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/sinew COMPONENT sinew)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSES/BSD-2-Clause.txt RENAME copyright
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libsinew-runtime-dev COMPONENT runtime)
include(CPack)
