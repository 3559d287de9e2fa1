# Installs the build tree BUILD_DIR to a temporary prefix, then configures, builds and runs the
# consumer project against it. Everything happens in WORK_DIR, which is emptied first.
#   cmake -DBUILD_DIR=... -DSOURCE_DIR=... -DWORK_DIR=... -DCXX=... -DGENERATOR=... -P run.cmake
foreach(variable BUILD_DIR SOURCE_DIR WORK_DIR CXX GENERATOR)
  if(NOT ${variable})
    message(FATAL_ERROR "${variable} is not given")
  endif()
endforeach()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(prefix "${WORK_DIR}/prefix")
file(REMOVE_RECURSE "${WORK_DIR}")
run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
if(NOT EXISTS "${prefix}/bin/tripus")
  message(FATAL_ERROR "the program was not installed to bin/tripus")
endif()
run("${prefix}/bin/tripus" --version)
file(GLOB_RECURSE hidden "${prefix}/include/tripus/*/detail/*.hpp")
if(hidden)
  message(FATAL_ERROR "headers of detail/ were installed: ${hidden}")
endif()

run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${WORK_DIR}/build" -G "${GENERATOR}"
    "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${CXX}" -DCMAKE_BUILD_TYPE=Release)
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build")
run("${WORK_DIR}/build/consumer")

# docs/theory.md (28), genus 2; twelve digits are enough to know the manifold.
string(STRIP "${output}" volume)
if(NOT volume MATCHES "^6\\.45199027083[0-9]*$")
  message(FATAL_ERROR "the consumer printed \"${volume}\", not the volume 6.45199027083...")
endif()
message(STATUS "the consumer printed ${volume}")
