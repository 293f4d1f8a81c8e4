# The install tree: headers under include/torse, static libraries, and the packages for CMake and for pkg-config.
include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/torse")

# Each component has its own export set, so that a consumer without GMP or FLINT can still use torse::torse.
function(torse_install target component folders)
  foreach(folder IN LISTS folders)
    if(EXISTS "${PROJECT_SOURCE_DIR}/${folder}")
      cmake_path(GET folder FILENAME name)
      install(DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/torse/${name}"
              FILES_MATCHING PATTERN "*.hpp" PATTERN coq EXCLUDE)
    endif()
  endforeach()
  install(TARGETS ${target} EXPORT torse-${component} ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(EXPORT torse-${component} NAMESPACE torse:: DESTINATION "${package_dir}")
endfunction()

cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_INCLUDEDIR BASE_DIRECTORY "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig"
           OUTPUT_VARIABLE relative_includedir)
function(torse_install_pkgconfig name)
  configure_file("cmake/${name}.pc.in" "${name}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/${name}.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endfunction()

list(TRANSFORM torse_folders PREPEND src/ OUTPUT_VARIABLE header_folders)
list(REMOVE_ITEM header_folders src/io)
torse_install(torse torse "${header_folders}")
torse_install_pkgconfig(torse)
if(TORSE_EXACT)
  torse_install(torse_exact exact exact)
  torse_install_pkgconfig(torse-exact)
  install(FILES cmake/FindGMP.cmake cmake/FindMPFR.cmake cmake/FindFLINT.cmake DESTINATION "${package_dir}")
endif()
if(TORSE_PROGRAM)
  torse_install(torse_io io src/io)
  torse_install(torse_proofs proofs "proofs;fuzz")
  if(TARGET torse_cli)
    install(TARGETS torse_cli DESTINATION "${CMAKE_INSTALL_BINDIR}")
  endif()
  if(TARGET torse_cad)
    install(TARGETS torse_cad DESTINATION lib/torse)
  endif()
endif()

configure_package_config_file(cmake/torse-config.cmake.in torse-config.cmake INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(torse-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/torse-config.cmake" "${PROJECT_BINARY_DIR}/torse-config-version.cmake"
        DESTINATION "${package_dir}")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
