# tripus_add_module(<name> [UNITED] [SOURCES ...] [PUBLIC lib ...] [PRIVATE lib ...])
#
# One library a module folder: target tripus_<name>, alias tripus::<name>,
# exported as tripus::<name>. PUBLIC names what its headers need, PRIVATE what
# only its sources need. UNITED: see TripusUnity.cmake. Headers lie beside their
# sources and are included from the root of the repository
# ("topology/triangulation.hpp").
include(GNUInstallDirs)

function(tripus_add_module name)
  cmake_parse_arguments(arg "UNITED" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target tripus_${name})
  tripus_leave_out(arg_SOURCES)
  list(APPEND arg_SOURCES ${TRIPUS_INSTEAD_${name}})
  if(arg_SOURCES)
    add_library(${target} ${arg_SOURCES})  # static, or shared with BUILD_SHARED_LIBS
    set(scope PUBLIC)
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(tripus::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} ${scope}
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/tripus>")
  target_compile_features(${target} ${scope} cxx_std_20)
  target_link_libraries(${target} ${scope} ${arg_PUBLIC})
  if(arg_PRIVATE AND arg_SOURCES)
    target_link_libraries(${target} PRIVATE ${arg_PRIVATE})
  endif()
  if(arg_UNITED OR (TRIPUS_LEAN AND arg_SOURCES AND NOT name STREQUAL "base"))
    tripus_unite(${target})
  endif()
  install(TARGETS ${target} EXPORT tripusTargets
          ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
          LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/"
          DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/tripus/${name}"
          FILES_MATCHING PATTERN "*.hpp" PATTERN "detail" EXCLUDE)
endfunction()
