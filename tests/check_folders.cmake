# Fails when folders of one layer include each other in a circle. What is known to close one stands here as "from > to";
# it goes with its circle: the test fails as well on an entry that is not there any more, or closes no circle.
cmake_minimum_required(VERSION 3.25)

set(known_core "")
set(known_io
  "io > io/case"
  "io/case/fields > io/case"
  "io/raster > io/dicom"
  "io/series > io"
  "io/volume > io")
set(known_ui
  "ui/actions > ui/dialogs"
  "ui/panels > ui"
  "ui/panels > ui/help"
  "ui/panels > ui/views/tools"
  "ui/views > ui/actions"
  "ui/views > ui/views/tools")
set(known_app
  "app > app/files"
  "app > app/habits"
  "app/editing > app"
  "app/editing > app/files"
  "app/editing > app/review"
  "app/help > app"
  "app/registration > app"
  "app/registration > app/files"
  "app/registration > app/review"
  "app/review > app"
  "app/review > app/files")

# Sets `edges` to "from > to" for every folder of the layer that includes another one of it.
function(find_edges layer)
  set(found "")
  file(GLOB_RECURSE sources RELATIVE "${ROOT}" "${ROOT}/${layer}/*.h" "${ROOT}/${layer}/*.cpp")
  foreach(source ${sources})
    get_filename_component(from "${source}" DIRECTORY)
    file(STRINGS "${ROOT}/${source}" includes REGEX "^ *#include \"${layer}/")
    foreach(include ${includes})
      string(REGEX REPLACE "^.*\"(.*)/[^/]*\".*$" "\\1" to "${include}")
      if(NOT to STREQUAL from)
        list(APPEND found "${from} > ${to}")
      endif()
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES found)
  set(edges "${found}" PARENT_SCOPE)
endfunction()

# Takes away every edge that leads to a folder from which none leads on, or from one to which none leads, until all that
# are left lie on circles or between them: `left`.
function(peel edges)
  set(left "${edges}")
  set(before "")
  while(NOT left STREQUAL before)
    set(before "${left}")
    string(REGEX REPLACE " > [^;]*" "" starts "${left}")
    string(REGEX REPLACE "[^;]* > " "" ends "${left}")
    set(left "")
    foreach(edge from to IN ZIP_LISTS before starts ends)
      if(to IN_LIST starts AND from IN_LIST ends)
        list(APPEND left "${edge}")
      endif()
    endforeach()
  endwhile()
  set(left "${left}" PARENT_SCOPE)
endfunction()

foreach(layer core io ui app)
  find_edges(${layer})
  set(others "${edges}")
  foreach(known ${known_${layer}})
    list(REMOVE_ITEM others "${known}")
  endforeach()
  peel("${others}")
  foreach(edge ${left})
    message(SEND_ERROR "${edge}: lies on a circle of folders, or between two")
  endforeach()
  if(left)
    continue()
  endif()
  foreach(known ${known_${layer}})
    if(NOT known IN_LIST edges)
      message(SEND_ERROR "${known}: nothing includes so any more; take it from the list in tests/check_folders.cmake")
      continue()
    endif()
    peel("${others};${known}")
    if(NOT left)
      message(SEND_ERROR "${known}: closes no circle any more; take it from the list in tests/check_folders.cmake")
    endif()
  endforeach()
endforeach()
