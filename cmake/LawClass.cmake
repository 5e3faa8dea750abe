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

# Whether a header of laws/ holds a law, or what several laws share: a law names itself.
function(is_law path result)
  file(STRINGS ${path} name REGEX "static constexpr const char\\* name = " LIMIT_COUNT 1)
  if(name)
    set(${result} TRUE PARENT_SCOPE)
  else()
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()
