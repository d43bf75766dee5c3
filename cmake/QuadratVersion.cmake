# SPDX-License-Identifier: Apache-2.0
# Which commit a binary is of: looked at with each build and written where it has changed, so that a commit compiles one
# file anew. As a script (cmake -P) it writes OUTPUT; included, it makes the library quadrat_version.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  set(version_source ${CMAKE_BINARY_DIR}/generated/version.cpp)
  add_custom_target(quadrat_commit BYPRODUCTS ${version_source}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${version_source} -DVERSION=${PROJECT_VERSION} -DSOURCE=${CMAKE_SOURCE_DIR}
            -P ${CMAKE_CURRENT_LIST_FILE}
    COMMENT "Which commit this is")
  add_library(quadrat_version STATIC ${version_source})
  target_include_directories(quadrat_version PRIVATE ${CMAKE_SOURCE_DIR}/app)
  target_link_libraries(quadrat_version PRIVATE quadrat_options)
  add_dependencies(quadrat_version quadrat_commit)
  return()
endif()

include(${CMAKE_CURRENT_LIST_DIR}/commit.cmake)
quadrat_commit(${SOURCE} commit)
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[// Written by cmake/QuadratVersion.cmake.
#include "machine/version.hpp"

namespace quadrat::machine {
std::string_view version() { return "@VERSION@+@commit@"; }
}  // namespace quadrat::machine
]])
