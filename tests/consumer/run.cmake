# Builds and runs projects that use Tripus as a library, the way that MODE says:
#   installed    the build tree BUILD_DIR, installed to a prefix; by the front door, and by the
#                component topology alone
#   subproject   Tripus as a part of the project, with shared libraries; and these installed
# Everything happens in WORK_DIR, which is emptied first.
#   cmake -DMODE=... -DBUILD_DIR=... -DSOURCE_DIR=... -DWORK_DIR=... -DCXX=... -DGENERATOR=... -P run.cmake
foreach(variable MODE BUILD_DIR SOURCE_DIR WORK_DIR CXX GENERATOR)
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

# build_project(<source> <name> [option...]): configures and builds it, in WORK_DIR/<name>.
function(build_project source name)
  run("${CMAKE_COMMAND}" -S "${source}" -B "${WORK_DIR}/${name}" -G "${GENERATOR}"
      "-DCMAKE_CXX_COMPILER=${CXX}" ${ARGN})
  run("${CMAKE_COMMAND}" --build "${WORK_DIR}/${name}")
endfunction()

# Runs a program and compares what it prints.
function(expect pattern program)
  run("${program}")
  string(STRIP "${output}" printed)
  if(NOT printed MATCHES "${pattern}")
    message(FATAL_ERROR "${program} printed \"${printed}\", which does not match ${pattern}")
  endif()
  message(STATUS "${program} printed ${printed}")
endfunction()

# docs/theory.md (28), genus 2; twelve digits are enough to know the manifold.
set(volume "^6\\.45199027083[0-9]*$")
set(prefix "${WORK_DIR}/prefix")
file(REMOVE_RECURSE "${WORK_DIR}")

if(MODE STREQUAL "installed")
  run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
  if(NOT EXISTS "${prefix}/bin/tripus")
    message(FATAL_ERROR "the program was not installed to bin/tripus")
  endif()
  run("${prefix}/bin/tripus" --version)
  file(GLOB_RECURSE hidden "${prefix}/include/tripus/*/detail/*.hpp")
  if(hidden)
    message(FATAL_ERROR "headers of detail/ were installed: ${hidden}")
  endif()
  build_project("${SOURCE_DIR}" front_door "-DCMAKE_PREFIX_PATH=${prefix}")
  expect("${volume}" "${WORK_DIR}/front_door/consumer")
  build_project("${SOURCE_DIR}/topology" topology "-DCMAKE_PREFIX_PATH=${prefix}")
  expect("^2 Z$" "${WORK_DIR}/topology/consumer")
elseif(MODE STREQUAL "subproject")
  cmake_path(GET SOURCE_DIR PARENT_PATH tests)
  cmake_path(GET tests PARENT_PATH root)
  build_project("${SOURCE_DIR}/subproject" subproject "-DTRIPUS_SOURCE=${root}" -DBUILD_SHARED_LIBS=ON)
  expect("${volume}" "${WORK_DIR}/subproject/consumer")
  run("${CMAKE_COMMAND}" --install "${WORK_DIR}/subproject" --prefix "${prefix}")
  build_project("${SOURCE_DIR}" shared "-DCMAKE_PREFIX_PATH=${prefix}")
  expect("${volume}" "${WORK_DIR}/shared/consumer")
else()
  message(FATAL_ERROR "MODE ${MODE}: installed or subproject")
endif()
