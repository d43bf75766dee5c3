# SPDX-License-Identifier: Apache-2.0
# What every target has in common, and the one way to declare a room of the house.

find_program(QUADRAT_CCACHE ccache)
if(QUADRAT_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${QUADRAT_CCACHE})
endif()

add_library(quadrat_options INTERFACE)
target_compile_options(quadrat_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
  # Heights, meshes and breeding are the same bit for bit wherever the code is compiled.
  -ffp-contract=off -fno-math-errno -fno-omit-frame-pointer)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # GCC 12 to 14 see uninitialised strings in every std::variant that holds one and is moved (GCC bug 109561).
  target_compile_options(quadrat_options INTERFACE -Wno-maybe-uninitialized)
endif()
if(QUADRAT_WERROR)
  target_compile_options(quadrat_options INTERFACE -Werror)
endif()
if(QUADRAT_SANITIZE)
  target_compile_options(quadrat_options INTERFACE -fsanitize=${QUADRAT_SANITIZE} -fno-sanitize-recover=all -g1)
  target_link_options(quadrat_options INTERFACE -fsanitize=${QUADRAT_SANITIZE})
endif()
if(QUADRAT_FUZZERS)
  target_compile_options(quadrat_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -g1)
  target_link_options(quadrat_options INTERFACE -fsanitize=address,undefined)
endif()
find_package(Threads REQUIRED)
target_link_libraries(quadrat_options INTERFACE Threads::Threads)

# quadrat_lightly_optimised(TARGET): for code that waits for others, or runs once. GCC takes half as long over it as with
# -O3. Sanitizers set a level of their own.
function(quadrat_lightly_optimised target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# quadrat_room(NAME [LIGHTLY_OPTIMISED] [LINK libs...])
# One static library for one folder: all of its *.cpp, recursively. Includes are written from app/
# ("mesh/field.hpp") or from the repository's root ("firmware-io/button_press.hpp").
function(quadrat_room name)
  cmake_parse_arguments(ROOM "LIGHTLY_OPTIMISED" "" "LINK;EXCLUDE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  foreach(pattern IN LISTS ROOM_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX ${pattern})
  endforeach()
  add_library(${name} STATIC ${sources})
  target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR}/app ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC quadrat_options ${ROOM_LINK})
  if(ROOM_LIGHTLY_OPTIMISED)
    quadrat_lightly_optimised(${name})
  endif()
  if(QUADRAT_FUZZERS)
    target_compile_options(${name} PRIVATE -fsanitize=fuzzer-no-link)  # what fuzzers look for new paths in
  endif()
endfunction()
