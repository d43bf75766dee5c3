# SPDX-License-Identifier: Apache-2.0
# cmake -DOUTPUT=library.cpp "-DFILES=a.facade;b.facade" -P embed.cmake
set(texts "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND texts "        {\"${name}\", R\"facade(${text})facade\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by app/synthesis/houses/types/embed.cmake.
#include \"synthesis/houses/facade.hpp\"

namespace quadrat::synthesis::houses {

const std::vector<NamedFacade>& facade_library() {
    static const std::vector<NamedFacade> kLibrary{
${texts}    };
    return kLibrary;
}

}  // namespace quadrat::synthesis::houses
")
