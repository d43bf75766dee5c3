# SPDX-License-Identifier: Apache-2.0
# cmake -DOUTPUT=x.cpp -DNAMESPACE=a::b -DHEADER=x.hpp -DFUNCTION=f "-DFILES=a.json;b.json" -P embed_texts.cmake
cmake_minimum_required(VERSION 3.25)
set(texts "")
foreach(file IN LISTS FILES)
  file(READ ${file} content)
  get_filename_component(stem ${file} NAME_WE)
  # A literal may be 64 KiB at most where compilers keep to the standard: long texts go in pieces.
  string(LENGTH "${content}" length)
  set(pieces "")
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${content}" ${at} 8000 piece)
    string(APPEND pieces "R\"embedded(${piece})embedded\"\n")
    math(EXPR at "${at} + 8000")
  endwhile()
  string(APPEND texts "    {\"${stem}\", ${pieces}},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by cmake/embed_texts.cmake.
#include \"${HEADER}\"

namespace ${NAMESPACE} {
namespace {

constexpr quadrat::base::EmbeddedText kTexts[] = {
${texts}};

}  // namespace

std::span<const quadrat::base::EmbeddedText> ${FUNCTION}() { return kTexts; }

}  // namespace ${NAMESPACE}
")
