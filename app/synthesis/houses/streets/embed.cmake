# SPDX-License-Identifier: Apache-2.0
# cmake -DOUTPUT=library.cpp "-DFILES=a.lsys;b.lsys" -P embed.cmake
set(texts "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND texts "        {\"${name}\", R\"lsys(${text})lsys\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by app/synthesis/houses/streets/embed.cmake.
#include \"synthesis/houses/street_grammar.hpp\"

namespace quadrat::synthesis::houses {

const std::vector<NamedStreets>& street_library() {
    static const std::vector<NamedStreets> kLibrary{
${texts}    };
    return kLibrary;
}

}  // namespace quadrat::synthesis::houses
")
