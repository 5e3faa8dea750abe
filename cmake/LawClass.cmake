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
