# What a lean build (TRIPUS_LEAN) leaves out: every source that needs a library which is more than
# headers, or what a browser does not have. Nothing else of a module changes. Where other sources call
# what is left out, TRIPUS_INSTEAD_<module> names the source that answers: the same by other means,
# or an Unsupported that says what the program can do.
#
# tripus_leave_out(<variable>)  takes the sources that are left out off a list.
set(TRIPUS_LEFT_OUT
  # Ceres, CHOLMOD
  solver/ceres_ solver/methods/ceres solver/detail/sparse_system.cpp solver/detail/ceres_silence
  # GLPK
  structure/detail/angle_programme.cpp
  # FLINT and Arb: proofs, and the minimiser in many digits
  structure/proof/ structure/detail/precise_minimiser
  canonical/census_proofs canonical/shipped_census_proofs
  # SQLite
  canonical/census_database canonical/database_file manifold/diagram_database
  # zlib: whoever calls the module unpacks
  base/compression
  # Surfaces and meshes: TetGen, pugixml, and much code
  meshing/
  # Solids
  parameterise/ manifold/parameterise
  # The window and the picture: OpenGL. What remains is what a page shows.
  viewer/camera viewer/faces/ viewer/half_space viewer/inside/ viewer/legend viewer/opencsg/ viewer/picture
  viewer/png viewer/scene viewer/window/ viewer/no_opengl viewer/web/gallery viewer/web/thumbnail
  viewer/web/page.cpp viewer/web_assets
  # The program's own files, tables and processes
  cli/census_lines cli/census_making cli/census_shard cli/shard cli/tricensus cli/view_pages
  # What speaks to a terminal; web/module has its own
  cli/interrupt cli/streams cli/output.cpp cli/progress
  cli/verbs/census cli/verbs/check cli/verbs/enumerate cli/verbs/hyperbolic cli/verbs/mesh
  cli/verbs/page cli/verbs/parameterise cli/verbs/prove cli/verbs/study cli/verbs/tube cli/verbs/view)

if(TRIPUS_LEAN)
  set(TRIPUS_INSTEAD_solver "${PROJECT_SOURCE_DIR}/solver/detail/sparse_system_eigen.cpp")
  set(TRIPUS_INSTEAD_structure "${PROJECT_SOURCE_DIR}/structure/detail/dense_angle_programme.cpp")
  set(TRIPUS_INSTEAD_meshing "${PROJECT_SOURCE_DIR}/web/module/absent_meshing.cpp")
endif()

function(tripus_leave_out variable)
  if(NOT TRIPUS_LEAN)
    return()
  endif()
  set(kept)
  foreach(source IN LISTS ${variable})
    cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
    foreach(root IN ITEMS "${PROJECT_BINARY_DIR}" "${PROJECT_SOURCE_DIR}")
      cmake_path(IS_PREFIX root "${path}" is_below)
      if(is_below)
        cmake_path(RELATIVE_PATH path BASE_DIRECTORY "${root}")
        break()
      endif()
    endforeach()
    set(is_kept TRUE)
    foreach(beginning IN LISTS TRIPUS_LEFT_OUT)
      string(FIND "${path}" "${beginning}" place)
      if(place EQUAL 0)
        set(is_kept FALSE)
      endif()
    endforeach()
    if(is_kept)
      list(APPEND kept "${source}")
    endif()
  endforeach()
  set(${variable} ${kept} PARENT_SCOPE)
endfunction()
