# What `cmake --install` puts under a prefix: the kernel, the culler and the C interface, which other programs link, with
# descriptions for CMake and pkg-config; documents and examples; and the command if it is built. No file contains the path of the build or of the prefix, so the
# prefix may be moved. Included once, from the top.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/occlude)
foreach(name IN LISTS occlude_installed)
  set_target_properties(occlude_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS occlude_${name} EXPORT occlude INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  get_target_property(public occlude_${name} OCCLUDE_PUBLIC)
  list(TRANSFORM public APPEND /)
  install(DIRECTORY ${public} TYPE INCLUDE)
endforeach()
set_target_properties(occlude_c PROPERTIES EXPORT_NAME c)
set(c_libraries occlude_c)
if(TARGET occlude_c_shared)
  set_target_properties(occlude_c_shared PROPERTIES EXPORT_NAME c_shared)
  list(APPEND c_libraries occlude_c_shared)
endif()
install(TARGETS ${c_libraries} EXPORT occlude INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${OCCLUDE_SOURCES}/culler/c/include/ TYPE INCLUDE)
install(EXPORT occlude NAMESPACE occlude:: FILE occlude-targets.cmake DESTINATION ${package_folder})

# Before 1.0 a new minor version may change the interface.
set(version_file ${PROJECT_BINARY_DIR}/package/occlude-config-version.cmake)
write_basic_package_version_file(${version_file} COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/occlude-config.cmake ${version_file} DESTINATION ${package_folder})

# Static libraries do not hold what they call of Highway.
set(pc_requires glm)
if(NOT BUILD_SHARED_LIBS)
  string(APPEND pc_requires " libhwy")
endif()
set(pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
set(pc_to_prefix /prefix)
cmake_path(RELATIVE_PATH pc_to_prefix BASE_DIRECTORY /prefix/${pc_folder})
foreach(name IN ITEMS occlude occlude-c)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/package/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/package/${name}.pc DESTINATION ${pc_folder})
endforeach()

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE TYPE DOC)
include(cmake/documents.cmake)
if(OCCLUDE_TOOLS)
  if(BUILD_SHARED_LIBS)
    cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_LIBDIR BASE_DIRECTORY ${CMAKE_INSTALL_FULL_BINDIR} OUTPUT_VARIABLE to_libraries)
    set_target_properties(occlude PROPERTIES INSTALL_RPATH "$ORIGIN/${to_libraries}")
  endif()
  install(TARGETS occlude)
  # Where culler/js/page/build.sh has made it. The program looks for it beside itself.
  install(FILES ${PROJECT_BINARY_DIR}/viewer.html TYPE BIN OPTIONAL)
  # The command writes its manual page and its completion itself.
  set(text_folder ${PROJECT_BINARY_DIR}/package/text)
  install(CODE "
    file(MAKE_DIRECTORY \"${text_folder}\")
    execute_process(COMMAND \"$<TARGET_FILE:occlude>\" help --man
      OUTPUT_FILE \"${text_folder}/occlude.1\" COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND \"$<TARGET_FILE:occlude>\" help --completion bash
      OUTPUT_FILE \"${text_folder}/occlude\" COMMAND_ERROR_IS_FATAL ANY)")
  install(FILES ${text_folder}/occlude.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${text_folder}/occlude DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endif()
