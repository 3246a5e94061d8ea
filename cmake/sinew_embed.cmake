# SPDX-License-Identifier: GPL-3.0-or-later
# sinew_embed(<target> <source> <name> <file>...): texts of the files, one after the other, as
# `extern const char* const <name>` in namespace sinew; made anew when one of them changes.
function(sinew_embed target source name)
  set(text "")
  foreach(file IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} content)
    string(APPEND text "${content}")
  endforeach()
  set(literals "")
  # A compiler need not take longer literals than 65536 characters; neighbours are one.
  string(LENGTH "${text}" length)
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 12000 part)
    string(APPEND literals "R\"PAGE(${part})PAGE\"\n")
    math(EXPR at "${at} + 12000")
  endwhile()
  file(CONFIGURE OUTPUT ${source} @ONLY NEWLINE_STYLE UNIX CONTENT
"// Made by sinew_embed from files of the source tree.
namespace sinew {
extern const char* const @name@;
const char* const @name@ =
@literals@;
}  // namespace sinew
")
  target_sources(${target} PRIVATE ${source})
endfunction()
