# Which Python the package is for, and whether it is built: sets TRIPUS_HAS_PYTHON.
# `pip install` says by itself; elsewhere it is the virtual environment that scripts/setup makes.
set(TRIPUS_HAS_PYTHON ${TRIPUS_PYTHON})
set(tripus_venv_python "${PROJECT_SOURCE_DIR}/build/venv/bin/python")
if(TRIPUS_PYTHON STREQUAL "AUTO")
  set(TRIPUS_HAS_PYTHON OFF)
  if(EXISTS "${tripus_venv_python}")
    set(TRIPUS_HAS_PYTHON ON)
  endif()
endif()
if(TRIPUS_HAS_PYTHON AND NOT SKBUILD AND NOT Python_EXECUTABLE)
  if(NOT EXISTS "${tripus_venv_python}")
    message(FATAL_ERROR "TRIPUS_PYTHON needs build/venv: run scripts/setup python, "
                        "or name a Python that has nanobind with -DPython_EXECUTABLE=")
  endif()
  set(Python_EXECUTABLE "${tripus_venv_python}" CACHE FILEPATH "For the Python package")
endif()
