// SPDX-License-Identifier: GPL-3.0-or-later
// A Zephyr module: copy the folder beside an application and name it in EXTRA_ZEPHYR_MODULES.
#include "generator/wrappers/template_text.h"

namespace sinew {
namespace {

const char* const zephyr_module = R"(# SPDX-License-Identifier: BSD-2-Clause
# Made by: sinew generate (--zephyr). Do not edit: change the model and generate again.
name: sinew_@MODEL@
build:
  cmake: zephyr
  kconfig: zephyr/Kconfig
)";

const char* const zephyr_kconfig = R"(# SPDX-License-Identifier: BSD-2-Clause
config SINEW_@UPPER@
	bool "Model @MODEL@, emitted by sinew"
	help
	  Compiles the emitted C of the model @MODEL@: no heap, no branch on data,
	  no library call. CONFIG_FPU has to be set where the processor has one.
)";

const char* const zephyr_cmake = R"(# SPDX-License-Identifier: BSD-2-Clause
# Made by: sinew generate (--zephyr). Do not edit: change the model and generate again.
if(CONFIG_SINEW_@UPPER@)
  zephyr_library()
  zephyr_library_sources(../source/@MODEL@.c ../source/@MODEL@_catalogue.c)
  zephyr_include_directories(../source)
  # Under these the emitted C gives the host's bits; without the last one gcc keeps stacks small.
  zephyr_library_compile_options(-O2 -ffp-contract=off -fno-math-errno -fno-tree-slp-vectorize
                                 -fno-schedule-insns)
endif()
)";

std::string zephyr_upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

FileSet zephyr_files(const WrappedModel& model) {
  const std::map<std::string, std::string> values{{"UPPER", zephyr_upper(model.name)}};
  FileSet files{{"zephyr/module.yml", filled(zephyr_module, model)},
                {"zephyr/Kconfig", filled(zephyr_kconfig, model, values)},
                {"zephyr/CMakeLists.txt", filled(zephyr_cmake, model, values)}};
  add_sources(files, model, "source/", false);
  return files;
}

}  // namespace sinew
