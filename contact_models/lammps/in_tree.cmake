# SPDX-License-Identifier: GPL-2.0-or-later
#
# Compiles the styles into LAMMPS itself. LAMMPS' own build includes this file if it is configured
# with
#
#   -D PKG_GRANULAR=yes -D CMAKE_PROJECT_lammps_INCLUDE=DIR/contact_models/lammps/in_tree.cmake
#
# CMake includes the file twice: after the command project() of LAMMPS, where it adds the styles to
# LAMMPS' lists, and at the end, where it adds the sources to the library `lammps`.

if(NOT TARGET lammps)
  foreach(style pair fix compute)
    string(TOUPPER ${style} list)
    set_property(GLOBAL APPEND PROPERTY ${list} ${CMAKE_CURRENT_LIST_DIR}/styles/${style}_plastigran.h)
  endforeach()
  set(PLASTIGRAN_IN_TREE ${CMAKE_CURRENT_LIST_FILE})
  cmake_language(DEFER CALL include ${PLASTIGRAN_IN_TREE})
  return()
endif()
if(NOT PKG_GRANULAR)
  message(FATAL_ERROR "PKG_GRANULAR is off. Plastigran needs it: add -D PKG_GRANULAR=yes.")
endif()

include(${CMAKE_CURRENT_LIST_DIR}/Sources.cmake)
target_sources(lammps PRIVATE ${sources})
target_include_directories(lammps PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/.. ${CMAKE_CURRENT_LIST_DIR}/styles)
target_compile_definitions(lammps PRIVATE PLASTIGRAN_LAMMPS_SOURCE)
target_compile_features(lammps PRIVATE cxx_std_17)
