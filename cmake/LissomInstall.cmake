# `cmake --install` and `find_package(lissom)`. The find modules travel along: a static lissom links what they find.
include(CMakePackageConfigHelpers)

set(lissom_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/lissom")

install(TARGETS lissom EXPORT lissomTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# Headers of the JSON layer, and those of the studio, which speaks JSON, need nlohmann_json and stay at home.
install(DIRECTORY lissom DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h" PATTERN "*_json.h" EXCLUDE
  PATTERN "lissom/editing" EXCLUDE PATTERN "lissom/studio" EXCLUDE)
install(EXPORT lissomTargets NAMESPACE lissom:: DESTINATION ${lissom_package_dir})
if(TARGET lissom_cli)
  install(TARGETS lissom_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

configure_package_config_file(cmake/lissomConfig.cmake.in "${PROJECT_BINARY_DIR}/lissomConfig.cmake"
  INSTALL_DESTINATION ${lissom_package_dir})
write_basic_package_version_file("${PROJECT_BINARY_DIR}/lissomConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/lissomConfig.cmake"
  "${PROJECT_BINARY_DIR}/lissomConfigVersion.cmake"
  cmake/FindCHOLMOD.cmake cmake/FindMETIS.cmake cmake/FindCairo.cmake cmake/FindLibzip.cmake
  DESTINATION ${lissom_package_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
