# tripus_unite(<target>)
#
# Compiles the sources of a target a dozen at a time, if TRIPUS_UNITY is on: from nothing that takes about
# half of the processor time, as each header and each template is then met once a dozen; after a change
# of one source it takes longer. So names in a target differ from one another, also those that only
# their file sees; the build of tests/consumer and the preset dev compile each source by itself, which
# finds includes that are missing. What is registered (formats, methods, flows) is a world of its own
# and stays apart; so do the tables of registries, which a program may replace.
option(TRIPUS_UNITY "Compile the sources of a module together: faster from nothing" OFF)

function(tripus_unite target)
  if(NOT TRIPUS_UNITY)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "(formats|methods|flows|steppers|functionals)/|_table\\.cpp$")
  set_source_files_properties(${sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
  # A file's own names are global names to the files that follow.
  target_compile_options(${target} PRIVATE -Wno-shadow)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()
