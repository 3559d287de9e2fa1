# tripus_precompile(<target> HEADERS <header>...)
#
# Heavy third-party headers, parsed once a target instead of once a source file. Nothing of Tripus
# itself belongs here, so that every source file still includes what it uses.
option(TRIPUS_PRECOMPILE "Precompile heavy third-party headers" ON)

function(tripus_precompile target)
  if(NOT TRIPUS_PRECOMPILE)
    return()
  endif()
  cmake_parse_arguments(arg "" "" "HEADERS" ${ARGN})
  target_precompile_headers(${target} PRIVATE ${arg_HEADERS})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # What ccache needs in order to see through a precompiled header.
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  elseif(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
endfunction()
