# tripus_plugin(<name> ARCHIVE <module> ENTRIES <source>... LINK <library>...)
#
# A shared library of a static module's objects, to be loaded by the program when it calls one of
# ENTRIES: what lies in these sources is not linked into the program itself.
#
# tripus_delay_load(<program> LIBRARIES <library>... [PLUGINS <name>...])
#
# Has a program load LIBRARIES and PLUGINS when it first calls a function of theirs, instead of
# when it starts (delay_load/stubs.py). The objects of the modules stay as they are.
set(TRIPUS_DELAY_LOAD_FOLDER "${CMAKE_CURRENT_LIST_DIR}/delay_load")

set(can_delay OFF)
if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64"
   AND NOT BUILD_SHARED_LIBS AND NOT TRIPUS_SANITIZE)
  find_package(Python3 COMPONENTS Interpreter QUIET)
  set(can_delay ${Python3_FOUND})
endif()
include(CMakeDependentOption)
cmake_dependent_option(TRIPUS_DELAY_LOAD
  "Let the program load graphics and other heavy libraries when it uses them" ON "can_delay" OFF)
if(TRIPUS_DELAY_LOAD)
  enable_language(ASM)
endif()

# Every static library that a target is linked from.
function(tripus_archives_of out target)
  set(found)
  set(waiting ${target})
  while(waiting)
    list(POP_FRONT waiting next)
    if(NOT TARGET ${next})
      continue()
    endif()
    get_target_property(alias ${next} ALIASED_TARGET)
    if(alias)
      set(next ${alias})
    endif()
    get_target_property(type ${next} TYPE)
    get_target_property(imported ${next} IMPORTED)
    if(next IN_LIST found OR imported)
      continue()
    endif()
    if(type STREQUAL "STATIC_LIBRARY")
      list(APPEND found ${next})
    endif()
    get_target_property(links ${next} LINK_LIBRARIES)
    foreach(link IN LISTS links)
      string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" link "${link}")
      list(APPEND waiting ${link})
    endforeach()
  endwhile()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

function(tripus_plugin name)
  cmake_parse_arguments(arg "" "ARCHIVE" "ENTRIES;LINK" ${ARGN})
  add_library(${name} SHARED $<TARGET_OBJECTS:${arg_ARCHIVE}>)
  target_link_libraries(${name} PRIVATE ${arg_LINK})
  target_link_options(${name} PRIVATE LINKER:--as-needed LINKER:--exclude-libs,ALL LINKER:--no-undefined)
  list(TRANSFORM arg_ENTRIES APPEND ".o")
  set_target_properties(${name} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib/tripus"
    TRIPUS_ENTRIES "${arg_ENTRIES}")
  install(TARGETS ${name} LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/tripus")
endfunction()

function(tripus_delay_load program)
  cmake_parse_arguments(arg "" "" "LIBRARIES;PLUGINS" ${ARGN})
  tripus_archives_of(archives ${program})
  set(entries)
  foreach(plugin IN LISTS arg_PLUGINS)
    get_target_property(sources ${plugin} TRIPUS_ENTRIES)
    list(APPEND entries ${sources})
  endforeach()
  list(TRANSFORM archives REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE archive_files)
  list(TRANSFORM arg_PLUGINS REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE plugin_files)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/delay_load")
  set(stubs "${folder}/stubs.S")
  set(table "${folder}/tripus_delayed_functions.inc")
  set(script "${TRIPUS_DELAY_LOAD_FOLDER}/stubs.py")
  add_custom_command(
    OUTPUT "${stubs}" "${table}"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${folder}"
    COMMAND "${Python3_EXECUTABLE}" "${script}" --nm "${CMAKE_NM}" --readelf "${CMAKE_READELF}"
            --objects ${archive_files}
            --libraries ${plugin_files} ${arg_LIBRARIES} --instead ${entries}
            --assembly "${stubs}" --table "${table}"
    DEPENDS ${archives} ${arg_PLUGINS} "${script}"
    VERBATIM COMMAND_EXPAND_LISTS)
  add_library(${program}_delayed OBJECT "${stubs}" "${table}" "${TRIPUS_DELAY_LOAD_FOLDER}/load.cpp")
  target_include_directories(${program}_delayed PRIVATE "${folder}" "${PROJECT_SOURCE_DIR}")
  # Before the archives, which have the entries too; what then nobody needs is not loaded.
  target_sources(${program} PRIVATE $<TARGET_OBJECTS:${program}_delayed>)
  target_link_options(${program} PRIVATE LINKER:--as-needed)
  target_link_libraries(${program} PRIVATE ${CMAKE_DL_LIBS})
  set_target_properties(${program} PROPERTIES
    BUILD_RPATH "${PROJECT_BINARY_DIR}/lib/tripus"
    INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}/tripus")
endfunction()
