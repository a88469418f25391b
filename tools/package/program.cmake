# What is installed of the program (tools/package/install.cmake has the rest).

# In the build folder it finds scenes and goldens as it does where it is installed.
set(data ${PROJECT_BINARY_DIR}/share/umbra78)
file(MAKE_DIRECTORY ${data})
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/tools/scenes ${data}/scenes SYMBOLIC)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/tests/goldens ${data}/goldens SYMBOLIC)
if(NOT PROJECT_IS_TOP_LEVEL OR umbra78_sanitize_some)
  return()
endif()
install(TARGETS umbra78)
install(DIRECTORY tools/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/umbra78)
install(DIRECTORY tests/goldens DESTINATION ${CMAKE_INSTALL_DATADIR}/umbra78)

# The manual page and the completion, by the program itself.
if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
  message(STATUS "umbra78: manual page and completion are left out (the program cannot run here)")
  return()
endif()
set(written ${PROJECT_BINARY_DIR}/generated/manual)
add_custom_command(OUTPUT ${written}/umbra78.1 ${written}/umbra78 VERBATIM DEPENDS umbra78
                   COMMAND ${CMAKE_COMMAND} -E make_directory ${written}
                   COMMAND umbra78 --manual > ${written}/umbra78.1
                   COMMAND umbra78 --completion > ${written}/umbra78)
add_custom_target(umbra78_manual ALL DEPENDS ${written}/umbra78.1 ${written}/umbra78)
install(FILES ${written}/umbra78.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${written}/umbra78 DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
