# SPDX-License-Identifier: GPL-2.0-or-later

# The class a law's header holds: vu_quoc_zhang.h holds VuQuocZhang.
function(law_class law result)
  string(REPLACE "_" ";" words ${law})
  set(class "")
  foreach(word ${words})
    string(SUBSTRING ${word} 0 1 first)
    string(SUBSTRING ${word} 1 -1 rest)
    string(TOUPPER ${first} first)
    string(APPEND class ${first}${rest})
  endforeach()
  set(${result} ${class} PARENT_SCOPE)
endfunction()

# Writes all_laws.h into the present binary folder: it includes every law and has their classes,
# separated by commas, as ALL_LAWS.
function(write_all_laws)
  set(include_dir ${PROJECT_SOURCE_DIR}/contact_models)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${include_dir} ${include_dir}/plastigran/laws/*.h)
  set(includes "")
  set(classes "")
  foreach(header ${headers})
    cmake_path(GET header STEM law)
    law_class(${law} class)
    string(APPEND includes "#include \"${header}\"\n")
    list(APPEND classes plastigran::${class})
  endforeach()
  list(JOIN classes ", " classes)
  file(CONFIGURE OUTPUT all_laws.h CONTENT "${includes}#define ALL_LAWS ${classes}\n" @ONLY)
endfunction()
