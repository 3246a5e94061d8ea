# SPDX-License-Identifier: GPL-3.0-or-later
# Everything the host program needs, as Debian 12 packages it.
find_package(PkgConfig REQUIRED)
pkg_check_modules(ginac REQUIRED IMPORTED_TARGET GLOBAL ginac>=1.8)
pkg_check_modules(cln REQUIRED IMPORTED_TARGET GLOBAL cln)
pkg_check_modules(urdfdom REQUIRED IMPORTED_TARGET GLOBAL urdfdom)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(tomlplusplus 3.3 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(Ceres 2.1 REQUIRED)
find_package(glog 0.6 REQUIRED)
find_package(OpenSSL 3.0 REQUIRED COMPONENTS Crypto)
find_package(Boost 1.74 REQUIRED)

# Readers of logs that are no text; without them such a log is refused with that reason.
pkg_check_modules(matio IMPORTED_TARGET GLOBAL matio)
pkg_check_modules(hdf5 IMPORTED_TARGET GLOBAL hdf5-serial)
pkg_check_modules(sqlite IMPORTED_TARGET GLOBAL sqlite3)
pkg_check_modules(zstd IMPORTED_TARGET GLOBAL libzstd)
pkg_check_modules(yaml IMPORTED_TARGET GLOBAL yaml-cpp)
