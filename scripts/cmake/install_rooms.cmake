# What `cmake --install` copies, and the package that find_package(dockyard) reads.
#
# Two sets: `controller` is what runs on a robot, `program` is all else. Each room has an include root of
# its own, include/dockyard/ROOM, as in the build: who links dockyard::controller cannot include a
# header of sim/, render/ or models/.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# dockyard_export(NAME SET): the target dockyard_NAME as dockyard::NAME.
function(dockyard_export name set)
  set_target_properties(dockyard_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS dockyard_${name} EXPORT dockyard_${set}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dockyard_${set})
endfunction()

# dockyard_install_room(NAME SET FOLDERS...): the library dockyard_NAME as dockyard::NAME, and the
# headers of its folders, not of folders in them, which are other rooms.
function(dockyard_install_room name set)
  dockyard_export(${name} ${set})
  set(root ${CMAKE_INSTALL_INCLUDEDIR}/dockyard/${name})
  foreach(folder IN LISTS ARGN)
    target_include_directories(dockyard_${name} INTERFACE $<INSTALL_INTERFACE:${root}>)
    file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h)
    install(FILES ${headers} DESTINATION ${root}/${folder} COMPONENT dockyard_${set})
  endforeach()
endfunction()

# The program, its data, and the package files. Called once, after all rooms are there.
function(dockyard_install_package)
  dockyard_export(flags controller)
  install(TARGETS dockyard RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT dockyard_program)
  set(data ${CMAKE_INSTALL_DATADIR}/dockyard)
  install(DIRECTORY models DESTINATION ${data} COMPONENT dockyard_program
    PATTERN parts EXCLUDE
    PATTERN read EXCLUDE
    PATTERN *.h EXCLUDE
    PATTERN *.cc EXCLUDE
    PATTERN CMakeLists.txt EXCLUDE)
  install(DIRECTORY scenarios examples DESTINATION ${data} COMPONENT dockyard_program
    PATTERN __pycache__ EXCLUDE)
  set(package ${CMAKE_INSTALL_LIBDIR}/cmake/dockyard)
  foreach(set controller program)
    install(EXPORT dockyard_${set} FILE dockyard-${set}-targets.cmake NAMESPACE dockyard::
      DESTINATION ${package} COMPONENT dockyard_${set})
  endforeach()
  configure_package_config_file(
    scripts/cmake/dockyard-config.cmake.in ${PROJECT_BINARY_DIR}/dockyard-config.cmake
    INSTALL_DESTINATION ${package} NO_SET_AND_CHECK_MACRO)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/dockyard-config-version.cmake
    COMPATIBILITY SameMinorVersion)  # before 1.0 a minor version may change anything
  install(FILES scripts/cmake/dockyard_apriltag.cmake scripts/cmake/dockyard_opencv.cmake
    ${PROJECT_BINARY_DIR}/dockyard-config.cmake ${PROJECT_BINARY_DIR}/dockyard-config-version.cmake
    DESTINATION ${package} COMPONENT dockyard_controller)
endfunction()
