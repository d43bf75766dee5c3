# SPDX-License-Identifier: Apache-2.0
# cmake -DOUTPUT=x.cpp -DNAMESPACE=a::b -DHEADER=x.hpp -DFUNCTION=f "-DFILES=a.json;b.json" -P embed_texts.cmake
cmake_minimum_required(VERSION 3.25)
set(texts "")
foreach(file IN LISTS FILES)
  file(READ ${file} content)
  get_filename_component(stem ${file} NAME_WE)
  # Its length is given: counting a long text's letters is more than a compiler does for a constant.
  string(LENGTH "${content}" length)
  string(APPEND texts "    {\"${stem}\", {R\"embedded(${content})embedded\", ${length}}},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by cmake/embed_texts.cmake.
#include \"${HEADER}\"

// A standard's compiler need not take more than 64 KiB; those that we use do.
#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace ${NAMESPACE} {
namespace {

constexpr quadrat::base::EmbeddedText kTexts[] = {
${texts}};

}  // namespace

std::span<const quadrat::base::EmbeddedText> ${FUNCTION}() { return kTexts; }

}  // namespace ${NAMESPACE}
")
