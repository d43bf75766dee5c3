# SPDX-License-Identifier: Apache-2.0
# cmake -DFOLDER=shaders -DOUTPUT=sources.cpp "-DSTAGES=a.vert;b.frag" -P embed.cmake
# An include is replaced by its file, each at most once a stage. #line LINE FILE tells the compiler where a line came
# from, FILE being an index into the stage's table of names.
cmake_minimum_required(VERSION 3.25)

function(newlines_in text count)
  string(REGEX MATCHALL "\n" found "${text}")
  list(LENGTH found found)
  set(${count} ${found} PARENT_SCOPE)
endfunction()

# The text of FILE with its includes in place; appends the names of the files met to the global property `names`.
function(expand file result)
  file(RELATIVE_PATH name ${FOLDER}/.. ${file})
  get_property(names GLOBAL PROPERTY names)
  list(LENGTH names number)
  set_property(GLOBAL APPEND PROPERTY names ${name})
  file(READ ${file} content)
  set(text "")
  set(line 1)
  while(TRUE)
    string(FIND "${content}" "#include \"" at)
    if(at EQUAL -1)
      break()
    endif()
    string(SUBSTRING "${content}" 0 ${at} before)
    string(SUBSTRING "${content}" ${at} -1 content)
    newlines_in("${before}" passed)
    math(EXPR line "${line} + ${passed}")
    string(APPEND text "${before}")
    string(REGEX MATCH "^#include \"([^\"\n]*)\"\n" directive "${content}")
    set(included ${FOLDER}/${CMAKE_MATCH_1})
    if(NOT directive OR NOT EXISTS ${included})
      message(FATAL_ERROR "${name}:${line}: there is no ${CMAKE_MATCH_1} in ${FOLDER}")
    endif()
    get_property(names GLOBAL PROPERTY names)
    list(FIND names shaders/${CMAKE_MATCH_1} seen)
    if(seen EQUAL -1)
      list(LENGTH names next)
      expand(${included} included_text)
      string(APPEND text "#line 1 ${next}\n${included_text}")
    endif()
    string(LENGTH "${directive}" length)
    string(SUBSTRING "${content}" ${length} -1 content)
    math(EXPR line "${line} + 1")
    string(APPEND text "#line ${line} ${number}\n")
  endwhile()
  set(${result} "${text}${content}" PARENT_SCOPE)
endfunction()

set(texts "")
set(table "")
set(count 0)
foreach(stage IN LISTS STAGES)
  set_property(GLOBAL PROPERTY names "")
  expand(${stage} text)
  get_property(names GLOBAL PROPERTY names)
  list(JOIN names "\", \"" files)
  get_filename_component(name ${stage} NAME)
  string(APPEND texts "constexpr std::string_view kFiles${count}[] = {\"${files}\"};\n"
                      "constexpr std::string_view kText${count} = R\"glsl(${text})glsl\";\n")
  string(APPEND table "    {\"${name}\", kText${count}, kFiles${count}},\n")
  math(EXPR count "${count} + 1")
endforeach()

file(WRITE ${OUTPUT} "// Made by shaders/embed.cmake.
#include \"shaders/sources.hpp\"

#include <cassert>

namespace quadrat::shaders {
namespace {

${texts}
constexpr Source kSources[] = {
${table}};

}  // namespace

std::span<const Source> sources() { return kSources; }

const Source& source(std::string_view name) {
    for (const Source& one : kSources)
        if (one.name == name) return one;
    assert(false && \"a shader of this name\");
    return kSources[0];
}

}  // namespace quadrat::shaders
")
