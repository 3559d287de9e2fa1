# Compiler settings shared by every target.
include(GNUInstallDirs)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT EMSCRIPTEN)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()
if(BUILD_SHARED_LIBS)
  set(CMAKE_INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
endif()

# In a project of another's, the place of programs and the kind of build are theirs to say.
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
endif()
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

# No fused multiply-add behind our back: the same source then gives the same
# bits on every x86-64, which the kernels' dispatch relies on.
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off)

# GCC 12 sees overlapping copies in std::string where there are none (its bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  add_compile_options(-Wno-restrict)
endif()

# A browser's compiler (TripusLean.cmake): its library lacks some of C++20, see web/README.md.
if(EMSCRIPTEN)
  add_compile_options(-fwasm-exceptions -msimd128 -Wno-overlength-strings)
  add_link_options(-fwasm-exceptions)
  include_directories(BEFORE "${PROJECT_SOURCE_DIR}/web/libcxx")
endif()

if(TRIPUS_SANITIZE)
  add_compile_definitions(TRIPUS_SANITIZED)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()

find_program(TRIPUS_CCACHE ccache)
if(PROJECT_IS_TOP_LEVEL AND TRIPUS_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # One cache serves every checkout.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}"
      CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      "${TRIPUS_CCACHE}")
endif()
