# Runs the window's program where there is no display: what the terminal can answer is answered there.
cmake_minimum_required(VERSION 3.25)

# expect(CODE PATTERN [WORD…]): the exit code, and what is said on either stream.
function(expect code pattern)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=DISPLAY --unset=WAYLAND_DISPLAY --unset=QT_QPA_PLATFORM
      LANGUAGE=C LC_ALL=C.UTF-8 XDG_CONFIG_HOME=/nonexistent ${PROGRAM} ${ARGN}
    RESULT_VARIABLE got OUTPUT_VARIABLE output ERROR_VARIABLE errors TIMEOUT 20)
  if(NOT got EQUAL code OR NOT "${output}${errors}" MATCHES "${pattern}")
    message(SEND_ERROR "angiopose ${ARGN}: exit code ${got} instead of ${code}, said:\n${output}${errors}")
  endif()
endfunction()

expect(0 "^AngioPose [0-9]+\\.[0-9]+\\.[0-9]+\n$" --version)
expect(0 "^AngioPose " -v)
expect(0 "--renderer" --help)
expect(0 "--renderer" -h)
expect(0 "^AngioPose " -platform offscreen --version)
expect(0 "^AngioPose " --style=fusion case.angiopose --version)
expect(2 "Unknown option 'nothing'" --nothing)
expect(2 "Unknown renderer" --renderer crayon)
expect(1 "No display is available" case.angiopose)
expect(2 "require --report" --register case.angiopose)
expect(2 "requires exactly one case" --report report.pdf)
expect(2 "written as .pdf or .html" --report report.doc case.angiopose)
expect(3 "nowhere.angiopose" --report report.pdf nowhere.angiopose)
