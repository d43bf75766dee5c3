// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/error.hpp"
#include "synthesis/trees/grammar.hpp"

namespace quadrat::synthesis::trees {

Grammar library_grammar(std::string_view name, std::span<const Redefinition> instead) {
    std::string known;
    for (const NamedGrammar& one : grammar_library()) {
        if (one.name == name) return read_grammar(one.text, std::string(name), instead);
        known += fmt::format("{}{}", known.empty() ? "" : ", ", one.name);
    }
    throw base::InputError(
        fmt::format("{}: no grammar of this name comes with the program; there are {}", name, known));
}

}  // namespace quadrat::synthesis::trees
