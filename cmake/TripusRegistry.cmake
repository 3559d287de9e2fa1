# tripus_registry(<folder> HEADER <header> NAMESPACE <namespace> ROW <type> [TABLE <function>])
#
# A table whose rows lie in the source files of a folder, so that adding an entry is adding a file.
# In the module solver, tripus_registry(methods HEADER solver/method.hpp NAMESPACE tripus::solver
# ROW Method) takes every solver/methods/FILE.cpp that has a namespace registered_methods, with
#     std::span<const Method> tripus::solver::registered_methods::FILE();
# in it, and writes the source of tripus::solver::methods(), which has all these rows in the order of
# base/registry.hpp. The files, with that one, are then in the variable <folder>_SOURCES. The function
# is called as the folder unless TABLE says otherwise.
#
# tripus_extend_registry(<target> <folder of the registry> <source>...)
#
# Has a program that is linked with the static module take more rows than the module has.
function(tripus_write_registry output header namespace row table files)
  set(declarations)
  set(calls)
  foreach(file IN LISTS files)
    get_filename_component(stem "${file}" NAME_WE)
    string(APPEND declarations "std::span<const ${row}> ${stem}();\n")
    string(APPEND calls "      registered_${table}::${stem}(),\n")
  endforeach()
  file(CONFIGURE OUTPUT "${output}" @ONLY CONTENT
"// Written by cmake/TripusRegistry.cmake from the names of files.
#include \"base/registry.hpp\"
#include \"@header@\"

namespace @namespace@ {
namespace registered_@table@ {
@declarations@}

std::span<const @row@> @table@() {
  static const auto rows = rows_in_order<@row@>({
@calls@  });
  return rows;
}

}  // namespace @namespace@
")
endfunction()

function(tripus_registry name)
  cmake_parse_arguments(arg "" "HEADER;NAMESPACE;ROW;TABLE" "" ${ARGN})
  if(NOT arg_TABLE)
    set(arg_TABLE ${name})
  endif()
  file(GLOB candidates CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp")
  tripus_leave_out(candidates)
  set(files)
  foreach(file IN LISTS candidates)
    file(STRINGS "${file}" marked REGEX "^namespace .*registered_${arg_TABLE} {" LIMIT_COUNT 1)
    if(marked)
      list(APPEND files "${file}")
    endif()
  endforeach()
  set(table "${CMAKE_CURRENT_BINARY_DIR}/${name}_table.cpp")
  tripus_write_registry("${table}" "${arg_HEADER}" "${arg_NAMESPACE}" "${arg_ROW}" "${arg_TABLE}"
                        "${files}")
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY "${PROJECT_SOURCE_DIR}"
             OUTPUT_VARIABLE folder)
  set_property(GLOBAL PROPERTY "TRIPUS_REGISTRY_${folder}/${name}"
               "${arg_HEADER}" "${arg_NAMESPACE}" "${arg_ROW}" "${arg_TABLE}" ${files})
  set(${name}_SOURCES ${files} "${table}" PARENT_SCOPE)
endfunction()

function(tripus_extend_registry target registry)
  get_property(known GLOBAL PROPERTY "TRIPUS_REGISTRY_${registry}")
  list(POP_FRONT known header namespace row table)
  set(output "${CMAKE_CURRENT_BINARY_DIR}/${target}_${table}.cpp")
  tripus_write_registry("${output}" "${header}" "${namespace}" "${row}" "${table}"
                        "${known};${ARGN}")
  target_sources(${target} PRIVATE ${ARGN} "${output}")
endfunction()
