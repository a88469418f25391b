# The module for Python: tools/python/main.cpp as umbra78._core, and module/__init__.py beside it.
# In the build folder it lies in python/; PYTHONPATH=build/release/python finds it there.
#
# The interpreter is UMBRA78_PYTHON: by default Debian's, whose packages have NumPy, or else the
# first one on the PATH.

set(UMBRA78_PYTHON "" CACHE FILEPATH "The Python that the module is for")
set(why "")
set(python "")
foreach(candidate IN ITEMS "${UMBRA78_PYTHON}" /usr/bin/python3 python3)
  if(candidate AND NOT python)
    execute_process(COMMAND ${candidate} -c "import numpy, sysconfig
print(sysconfig.get_path('include'), sysconfig.get_config_var('EXT_SUFFIX'), sep=';')"
                    OUTPUT_VARIABLE answer ERROR_QUIET RESULT_VARIABLE failed
                    OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT failed)
      set(python ${candidate})
      list(GET answer 0 python_headers)
      list(GET answer 1 python_suffix)
    endif()
  endif()
endforeach()
find_path(UMBRA78_PYBIND11 pybind11/pybind11.h)
if(UMBRA78_SANITIZE)
  set(why "not built for sanitizers")
elseif(NOT python)
  set(why "missing: python3-numpy")
elseif(NOT EXISTS ${python_headers}/Python.h)
  set(why "missing: python3-dev")
elseif(NOT UMBRA78_PYBIND11)
  set(why "missing: pybind11-dev")
endif()

if(why)
  message(STATUS "umbra78: the module for Python is left out (${why})")
else()
  set(module ${PROJECT_BINARY_DIR}/python/umbra78)
  add_library(umbra78_python MODULE tools/python/main.cpp)
  umbra78_linked_anywhere(umbra78_python)
  umbra78_core_first(umbra78_python)
  set_target_properties(umbra78_python PROPERTIES OUTPUT_NAME _core PREFIX ""
                        SUFFIX ${python_suffix} LIBRARY_OUTPUT_DIRECTORY ${module})
  target_include_directories(umbra78_python SYSTEM PRIVATE ${python_headers} ${UMBRA78_PYBIND11})
  target_link_libraries(umbra78_python PRIVATE umbra78_tools_python)
  target_link_options(umbra78_python PRIVATE -Wl,--exclude-libs,ALL)
  target_compile_options(umbra78_python PRIVATE $<$<CONFIG:Release>:-Og>)
  file(MAKE_DIRECTORY ${module})
  foreach(file IN ITEMS __init__.py __init__.pyi py.typed)
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/tools/python/module/${file} ${module}/${file} SYMBOLIC)
  endforeach()
  if(PROJECT_IS_TOP_LEVEL)  # where Debian's Python looks, below any prefix
    set(packages lib/python3/dist-packages/umbra78)
    install(TARGETS umbra78_python LIBRARY DESTINATION ${packages})
    install(FILES tools/python/module/__init__.py tools/python/module/__init__.pyi
            tools/python/module/py.typed DESTINATION ${packages})
  endif()
endif()

# Its tests; where it is not built they are skipped, with the reason.
if(BUILD_TESTING)
  add_test(NAME python COMMAND bash ${PROJECT_SOURCE_DIR}/tests/tools/python/run.sh
           "${why}" "${python}" ${PROJECT_BINARY_DIR})
  set_tests_properties(python PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 900 COST 20)
endif()
