# The third-party libraries of a lean build: those that are headers only, from one folder of links to
# them (a compiler for another system must not see the rest of /usr/include), and empty targets in the
# place of the others, whose callers are left out (TripusLean.cmake).
set(TRIPUS_HEADERS "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${TRIPUS_HEADERS}")
set(from_Eigen /usr/include/eigen3/Eigen)
set(from_unsupported /usr/include/eigen3/unsupported)
foreach(library Eigen unsupported boost fmt nlohmann CLI)
  if(NOT from_${library})
    set(from_${library} "/usr/include/${library}")
  endif()
  if(NOT EXISTS "${from_${library}}")
    message(FATAL_ERROR "${from_${library}} is missing: scripts/setup build browser installs it")
  endif()
  file(CREATE_LINK "${from_${library}}" "${TRIPUS_HEADERS}/${library}" SYMBOLIC)
endforeach()

foreach(target Eigen3::Eigen Boost::headers fmt::fmt nlohmann_json::nlohmann_json CLI11::CLI11)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE "${TRIPUS_HEADERS}")
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
foreach(target Ceres::ceres Cholmod::Cholmod Glpk::Glpk Gmp::Gmp Arb::Arb SQLite::SQLite3 ZLIB::ZLIB
        pugixml::pugixml Stb::Stb Threads::Threads)
  add_library(${target} INTERFACE IMPORTED)
endforeach()
target_include_directories(pugixml::pugixml INTERFACE "${PROJECT_SOURCE_DIR}/web/module/xml")  # ours
target_include_directories(Gmp::Gmp SYSTEM INTERFACE "${TRIPUS_HEADERS}")  # Boost's in its place
target_compile_definitions(Gmp::Gmp INTERFACE TRIPUS_WITHOUT_GMP)
add_library(tripus::studies INTERFACE IMPORTED)  # no module of a lean build
