# What `cmake --install` puts where, and the Debian package of it. Nothing that is installed knows
# where it was built: the program finds its scenes and goldens from where it stands.
#
#   bin/umbra78                      the program
#   include/umbra78/...              the core's headers, as they are included here; umbra78.h for C
#   lib/libumbra78.a, .so            umbra78::core, and its C face alone, umbra78::c
#   lib/cmake/umbra78                find_package(umbra78)
#   share/umbra78/scenes, goldens    what `umbra78 figures` draws and compares
#   share/man, share/bash-completion both written by the program, from its own tables
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# One archive of all rooms of the core, and one shared object that shows the C face alone.
set(rooms umbra78_hw umbra78_hw_memory umbra78_hw_clocked umbra78_hw_ap120b umbra78_raster
    umbra78_shadow umbra78_shadow_filters umbra78_shadow_rivals umbra78_shadow_clocked
    umbra78_shadow_ap120b umbra78_shadow_frame umbra78_shadow_c)
set(objects "")
foreach(room IN LISTS rooms)
  get_target_property(kind ${room} TYPE)
  if(kind STREQUAL "STATIC_LIBRARY")  # a room may be left out
    list(APPEND objects $<TARGET_OBJECTS:${room}>)
  endif()
endforeach()
add_library(umbra78_core STATIC ${objects})
add_library(umbra78_c SHARED ${objects})
foreach(target IN ITEMS umbra78_core umbra78_c)
  string(REPLACE umbra78_ "" name ${target})
  add_library(umbra78::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME umbra78 EXPORT_NAME ${name}
                        LINKER_LANGUAGE CXX)
  target_include_directories(${target} INTERFACE
                             $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/shadow/c>)
endforeach()
set_target_properties(umbra78_c PROPERTIES VERSION ${PROJECT_VERSION}
                      SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_compile_features(umbra78_core INTERFACE cxx_std_20)
if(left_out GREATER 0)
  target_compile_definitions(umbra78_core INTERFACE UMBRA78_LEFT_OUT=${left_out})
endif()
if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()

set(headers ${CMAKE_INSTALL_INCLUDEDIR}/umbra78)
install(TARGETS umbra78_core umbra78_c EXPORT umbra78 INCLUDES DESTINATION
        ${headers} ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY fixed hw raster shadow DESTINATION ${headers}
        FILES_MATCHING PATTERN "*.hpp" PATTERN "machine" EXCLUDE PATTERN "c" EXCLUDE)
install(FILES shadow/c/umbra78.h DESTINATION ${headers})
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/umbra78)
install(EXPORT umbra78 NAMESPACE umbra78:: FILE umbra78Config.cmake DESTINATION ${package})
# The core's classes change between versions; a program is compiled with the one it was written for.
write_basic_package_version_file(generated/umbra78ConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/generated/umbra78ConfigVersion.cmake DESTINATION ${package})
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The umbra78 project <umbra78@invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Curved shadows of 1978, bit for bit: program and library")
set(CPACK_PACKAGE_DESCRIPTION "An emulation, in exact integers, of the machine of Lance Williams'
 paper on casting curved shadows on curved surfaces (SIGGRAPH 78): the program, its core as a library
 for C++ and C, and a module for Python.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-numpy, bash-completion, cmake, g++")
find_program(UMBRA78_SHLIBDEPS dpkg-shlibdeps)
if(UMBRA78_SHLIBDEPS)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
endif()
include(CPack)
