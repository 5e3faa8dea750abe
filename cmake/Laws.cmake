# SPDX-License-Identifier: GPL-2.0-or-later

# Sets `result` to the class that the header of a law contains: VuQuocZhang for vu_quoc_zhang.h.
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

# Sets `result` to the names of all laws, which are the names of their headers.
function(find_laws result)
  set(laws_dir ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../contact_models/plastigran/laws)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${laws_dir} ${laws_dir}/*.h)
  list(TRANSFORM headers REPLACE "\\.h$" "")
  set(${result} ${headers} PARENT_SCOPE)
endfunction()

# Writes all_laws.h to the current binary folder. The file includes the header of every law and
# defines ALL_LAWS, the comma-separated list of their classes.
function(write_all_laws)
  set(includes "")
  set(classes "")
  find_laws(laws)
  foreach(law ${laws})
    law_class(${law} class)
    string(APPEND includes "#include \"plastigran/laws/${law}.h\"\n")
    list(APPEND classes plastigran::${class})
  endforeach()
  list(JOIN classes ", " classes)
  file(CONFIGURE OUTPUT all_laws.h CONTENT "${includes}#define ALL_LAWS ${classes}\n" @ONLY)
endfunction()
