# SPDX-License-Identifier: GPL-3.0-or-later
# Several tests in one translation unit, so that headers and templates are compiled once for all of
# them. Tests name their helpers as they like, so each source is read within a namespace of its own, behind
# all headers of all the sources (which are read once, and in the global namespace).

# What cannot be read within a namespace, or makes something for other sources: compiled alone.
set(SINEW_ALONE "^(namespace [A-Za-z:_]+ {|template ?<>|extern \"C\"|int main|#(if|define|undef|pragma))")

# sinew_join_tests(<room> <list of the sources to compile>): replaces joinable sources in the list by files
# that include some of them each. A source that changes makes CMake look again at what it includes.
function(sinew_join_tests room list)
  set(sources ${${list}})
  set(chosen)
  set(joined)
  foreach(source IN LISTS sources)
    file(STRINGS ${source} tests REGEX "TEST_CASE\\(")
    file(STRINGS ${source} alone REGEX "${SINEW_ALONE}")
    if(tests AND NOT alone)
      list(APPEND joined ${source})
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    else()
      list(APPEND chosen ${source})
    endif()
  endforeach()
  set(most 10)  # more take too much memory, and leave a core without work
  set(number 0)
  list(LENGTH joined count)
  while(count GREATER 0)
    list(SUBLIST joined 0 ${most} part)
    list(REMOVE_ITEM joined ${part})
    list(LENGTH joined count)
    set(headers)
    set(bodies)
    foreach(source IN LISTS part)
      file(STRINGS ${source} own REGEX "^#include ")
      list(APPEND headers ${own})
      get_filename_component(name ${source} NAME_WE)
      string(MAKE_C_IDENTIFIER ${name} name)
      string(APPEND bodies "namespace of_${name} {\n#include \"${source}\"\n}\n")
    endforeach()
    list(REMOVE_DUPLICATES headers)
    list(JOIN headers "\n" headers)
    set(file ${CMAKE_CURRENT_BINARY_DIR}/joined/${room}_${number}.cpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "${headers}\n${bodies}" @ONLY)
    list(APPEND chosen ${file})
    math(EXPR number "${number} + 1")
  endwhile()
  set(${list} ${chosen} PARENT_SCOPE)
endfunction()
