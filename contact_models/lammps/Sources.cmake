# SPDX-License-Identifier: GPL-2.0-or-later
#
# Sets `sources` to the files of the styles, and generates one file for each law.

include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/Laws.cmake)
find_laws(laws)
set(sources contact_line.cpp contact_tally.cpp energy_balance.cpp energy_compute.cpp
  impact_extremes.cpp load_model.cpp normal_model.cpp pair_style.cpp particle_values.cpp
  run_time_checks.cpp tangential_model.cpp wall_style.cpp)
list(TRANSFORM sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
set(law_declarations "")
set(law_addresses "")
foreach(law ${laws})
  law_class(${law} class)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/law.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/law_${law}.cpp @ONLY)
  list(APPEND sources ${CMAKE_CURRENT_BINARY_DIR}/law_${law}.cpp)
  string(APPEND law_declarations "extern const NamedLaw law_${law};\n")
  list(APPEND law_addresses "&law_${law}")
endforeach()
list(JOIN law_addresses ", " law_addresses)
configure_file(${CMAKE_CURRENT_LIST_DIR}/named_laws.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/named_laws.cpp @ONLY)
list(APPEND sources ${CMAKE_CURRENT_BINARY_DIR}/named_laws.cpp)
