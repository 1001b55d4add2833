# Installs the library into an empty place, checks its headers, builds the examples against it as a stranger would, and runs
# them: what they find must be what the command line finds.
cmake_minimum_required(VERSION 3.25)
set(prefix ${WORK}/prefix)
set(examples ${WORK}/examples)

function(run)
  cmake_parse_arguments(PARSE_ARGV 0 run "" "OUTPUT;FOLDER" "COMMAND;ALLOW")
  if(NOT run_FOLDER)
    set(run_FOLDER ${WORK})
  endif()
  execute_process(COMMAND ${run_COMMAND} WORKING_DIRECTORY ${run_FOLDER} RESULT_VARIABLE code OUTPUT_VARIABLE output
    ERROR_VARIABLE errors)
  if(NOT code EQUAL 0 AND NOT code IN_LIST run_ALLOW)
    message(FATAL_ERROR "${run_COMMAND}\nexit code ${code}\n${output}${errors}")
  endif()
  if(run_OUTPUT)
    set(${run_OUTPUT} "${output}" PARENT_SCOPE)
  endif()
endfunction()

# Each component brings what it is for, and nothing else.
function(expect_installed component)
  file(REMOVE_RECURSE ${WORK}/component)
  run(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/component --component ${component})
  file(GLOB_RECURSE files RELATIVE ${WORK}/component ${WORK}/component/*)
  foreach(pattern ${ARGN})
    set(matching ${files})
    list(FILTER matching INCLUDE REGEX "${pattern}")
    if(NOT matching)
      message(SEND_ERROR "component ${component} lacks ${pattern}: ${files}")
    endif()
  endforeach()
  foreach(file ${files})
    string(REPLACE ";" "|" known "${ARGN}")
    if(NOT file MATCHES "${known}")
      message(SEND_ERROR "component ${component} has ${file}")
    endif()
  endforeach()
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
expect_installed(library "${LIBRARY_FOLDER}/libangiopose\\.so\\.[0-9]+\\.[0-9]+\\.[0-9]+" "libangiopose\\.so\\.[0-9]+\\.[0-9]+"
  "libexec/angiopose/angiopose-decode-itk$" "libexec/angiopose/angiopose-decode-vtk$")
expect_installed(development "include/angiopose/" "${LIBRARY_FOLDER}/cmake/AngioPose/" "${LIBRARY_FOLDER}/libangiopose\\.so$")
foreach(component library development)
  run(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component ${component})
endforeach()

# What installed documents link to is installed with them, but for the source.
run(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/documents --component doc)
file(GLOB_RECURSE documents ${WORK}/documents/*.md)
list(LENGTH documents document_count)
if(document_count LESS 10)
  message(SEND_ERROR "only ${document_count} documents are installed")
endif()
foreach(document ${documents})
  file(READ ${document} text)
  string(REPLACE "](" "\nlink " text "${text}")
  string(REGEX REPLACE "[][;]" "" text "${text}")   # they would join or split what is listed
  string(REGEX MATCHALL "\nlink [^)# \n]+" links "${text}")
  cmake_path(GET document PARENT_PATH folder)
  foreach(link ${links})
    string(SUBSTRING "${link}" 6 -1 target)
    if(NOT target MATCHES "^[a-z]+:|^(\\.\\./)*(core|io|ui|app|tests|packaging|CMake[A-Za-z]+\\.[a-z]+)(/|$)" AND NOT EXISTS ${folder}/${target})
      message(SEND_ERROR "${document} links to ${target}, which is not installed")
    endif()
  endforeach()
endforeach()

# Every public header compiles alone, as strictly as anyone may wish, and sees Eigen and the standard library only.
file(GLOB headers RELATIVE ${prefix}/include ${prefix}/include/angiopose/*.h)
list(LENGTH headers header_count)
if(header_count LESS 10)
  message(SEND_ERROR "only ${header_count} public headers are installed")
endif()
foreach(header ${headers})
  file(WRITE ${WORK}/alone.cpp "#include <${header}>\n#include <${header}>\nint main() {}\n")
  run(OUTPUT seen COMMAND ${CXX} -std=c++20 -Wall -Wextra -Wpedantic -Wshadow -Werror -fsyntax-only -H
    -isystem /usr/include/eigen3 -I${prefix}/include ${WORK}/alone.cpp)
  run(OUTPUT seen COMMAND ${CXX} -std=c++20 -M -isystem /usr/include/eigen3 -I${prefix}/include ${WORK}/alone.cpp)
  string(REGEX MATCHALL "[^ \n\\]*(/ITK|/vtk|/opencv|/dcmtk|/qt6|/Qt|/nlohmann|/core/|/io/)[^ \n\\]*\\.h[^ \n]*" strangers "${seen}")
  list(FILTER strangers EXCLUDE REGEX "eigen3/|/c\\+\\+/")
  if(strangers)
    message(SEND_ERROR "${header} includes ${strangers}")
  endif()
endforeach()

# Of its own the library shows namespace angiopose, and of that nothing that is inside core or io.
run(OUTPUT symbols COMMAND nm -DC --defined-only ${prefix}/${LIBRARY_FOLDER}/libangiopose.so)
if(NOT symbols MATCHES "angiopose::registerVessels" OR symbols MATCHES " T angiopose::(core|io|library)::")
  message(SEND_ERROR "the library shows too little or too much")
endif()

# The examples by find_package, also for a processor whose wider vectors Eigen would align to.
run(COMMAND ${CMAKE_COMMAND} -S ${ROOT}/resources/examples/cpp -B ${examples} -DCMAKE_BUILD_TYPE=Debug
  -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_PREFIX_PATH=${prefix} "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror -DEIGEN_MAX_ALIGN_BYTES=64")
run(COMMAND ${CMAKE_COMMAND} --build ${examples})

# The installed library finds the helper programs that are installed with it.
file(WRITE ${WORK}/pose.cpp "#include <angiopose/registration.h>
int main()
{
    angiopose::Pose pose = angiopose::Pose::Identity();
    pose(0, 3) = 0.1;
    angiopose::writePose(pose, \"pose.h5\");
    return angiopose::readPose(\"pose.h5\") == pose ? 0 : 1;
}
")
run(COMMAND ${CXX} -std=c++20 -isystem /usr/include/eigen3 -I${prefix}/include ${WORK}/pose.cpp -o ${WORK}/pose
  -L${prefix}/${LIBRARY_FOLDER} -langiopose -Wl,-rpath,${prefix}/${LIBRARY_FOLDER})
run(COMMAND ${WORK}/pose)
file(GLOB sources ${ROOT}/resources/examples/*/*.cpp ${ROOT}/resources/examples/*/*.py)
foreach(source ${sources})
  file(READ ${source} text)
  string(REGEX MATCHALL "\n" lines "${text}")   # file(STRINGS) also ends a line at a sign beyond ASCII
  list(LENGTH lines count)
  if(count GREATER 40)
    message(SEND_ERROR "${source} has ${count} lines; an example has 40 at most")
  endif()
endforeach()

run(COMMAND ${CLI} simulate --seed 7 --output demo)
run(COMMAND ${CLI} register demo/case.angiopose --output by-cli ALLOW 4)
run(COMMAND ${CLI} trace-angiogram demo/angiogram.dcm --output by-cli/target.csv)
run(COMMAND ${examples}/register_arrays)
run(COMMAND ${examples}/simulate_and_stop)
run(COMMAND ${examples}/register_case demo/case.angiopose result.json ALLOW 4)
run(COMMAND ${examples}/trace_image demo/angiogram.dcm target.csv)

function(expect_same ours theirs)
  file(READ ${WORK}/${ours} mine)
  file(READ ${WORK}/${theirs} other)
  if(ours MATCHES "json$")   # how long it took, when and for whom differs from run to run
    foreach(key timeMs time author)
      string(JSON mine SET "${mine}" ${key} null)
      string(JSON other SET "${other}" ${key} null)
    endforeach()
  endif()
  if(NOT mine STREQUAL other)
    message(SEND_ERROR "${ours} and ${theirs} differ:\n${mine}\n${other}")
  endif()
endfunction()
expect_same(result.json by-cli/result.json)
expect_same(target.csv by-cli/target.csv)
