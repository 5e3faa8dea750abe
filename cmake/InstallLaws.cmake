# SPDX-License-Identifier: GPL-2.0-or-later
#
# Installs the headers of the laws for other projects, which use find_package(plastigran) and the
# target plastigran::laws.
include(CMakePackageConfigHelpers)

set_target_properties(plastigran_laws PROPERTIES EXPORT_NAME laws)
target_compile_features(plastigran_laws INTERFACE cxx_std_17)
install(TARGETS plastigran_laws EXPORT plastigran COMPONENT laws)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/contact_models/plastigran DESTINATION include
        COMPONENT laws FILES_MATCHING PATTERN "*.h")
set(package_dir share/cmake/plastigran)  # share, not lib, because headers are independent of the machine
install(EXPORT plastigran NAMESPACE plastigran:: FILE plastigran-config.cmake
        DESTINATION ${package_dir} COMPONENT laws)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plastigran-config-version.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/plastigran-config-version.cmake
        DESTINATION ${package_dir} COMPONENT laws)
