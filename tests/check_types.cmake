# Fails when two headers of one layer, which is one namespace, define types of the same name: each compiles, and the
# linker takes one's copies of members for the other's.
cmake_minimum_required(VERSION 3.25)

foreach(layer core io ui app)
  file(GLOB_RECURSE headers RELATIVE "${ROOT}" "${ROOT}/${layer}/*.h")
  list(FILTER headers EXCLUDE REGEX "^app/library/include/")   # a namespace of its own
  set(names "")
  foreach(header ${headers})
    file(STRINGS "${ROOT}/${header}" definitions REGEX "^(struct|class|enum class) [A-Za-z0-9]+( [^;]*)?$")
    foreach(definition ${definitions})
      string(REGEX REPLACE "^(struct|class|enum class) ([A-Za-z0-9]+).*$" "\\2" name "${definition}")
      if(name IN_LIST names)
        message(SEND_ERROR "${header} and ${where_${layer}_${name}} both define ${name}")
      endif()
      list(APPEND names ${name})
      set(where_${layer}_${name} ${header})
    endforeach()
  endforeach()
  list(LENGTH names count)
  if(count LESS 50)
    message(SEND_ERROR "only ${count} types found in ${layer}")
  endif()
endforeach()
