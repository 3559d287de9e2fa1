# Install and export: find_package(tripus) then tripus::<module>.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(TRIPUS_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/tripus")
if(TARGET tripus)  # the program, cli/
  install(TARGETS tripus RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
  install(FILES "${PROJECT_SOURCE_DIR}/data/census.tsv"
                "${PROJECT_BINARY_DIR}/share/tripus/census.sqlite"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/tripus")
  # For `tripus page`, if scripts/page has made it.
  install(FILES "${PROJECT_SOURCE_DIR}/build/page/tripus.html"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/tripus" OPTIONAL)
endif()
install(EXPORT tripusTargets NAMESPACE tripus:: DESTINATION "${TRIPUS_CMAKE_DIR}")
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/tripusConfig.cmake.in" "${PROJECT_BINARY_DIR}/tripusConfig.cmake"
  INSTALL_DESTINATION "${TRIPUS_CMAKE_DIR}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/tripusConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/tripusConfig.cmake"
              "${PROJECT_BINARY_DIR}/tripusConfigVersion.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindArb.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindCholmod.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindGlpk.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindGmp.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindOpenCSG.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindStb.cmake"
        DESTINATION "${TRIPUS_CMAKE_DIR}")
