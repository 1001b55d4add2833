# Fails when a source outside io/support/system asks the system by itself: what another system would have to do otherwise
# stands in that one folder.
cmake_minimum_required(VERSION 3.25)

# Still to be moved there. The test fails as well on a name that is clean by now.
set(known io/support/atomic_file.cpp)

set(headers "unistd|fcntl|sys/[a-z_]+|signal|poll|spawn|dlfcn|link|malloc|pthread|dirent|termios|pwd|grp|sched|netdb|netinet/[a-z]+|arpa/[a-z]+")
foreach(layer core io ui app)
  file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/${layer}/*.h ${ROOT}/${layer}/*.cpp)
  foreach(source ${sources})
    if(source MATCHES "^io/support/system/")
      continue()
    endif()
    file(STRINGS ${ROOT}/${source} hits REGEX "^ *#include *<(${headers})\\.h>|(mkstemp|isatty|sysconf) *\\(|\"/proc/")
    if(hits AND NOT source IN_LIST known)
      message(SEND_ERROR "${source} asks the system by itself; io/support/system is the place for it:\n${hits}")
    elseif(NOT hits AND source IN_LIST known)
      message(SEND_ERROR "${source} is clean; take it from the list in tests/check_system_calls.cmake")
    endif()
  endforeach()
endforeach()
