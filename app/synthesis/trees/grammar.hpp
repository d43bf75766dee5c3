// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "synthesis/lsystem/grammar.hpp"

namespace quadrat::synthesis::trees {

using lsystem::Chance;
using lsystem::contexts_in_vain;
using lsystem::Derivation;
using lsystem::derive;
using lsystem::DeriveOptions;
using lsystem::Expression;
using lsystem::Grammar;
using lsystem::kMostArguments;
using lsystem::kMostParameters;
using lsystem::Production;
using lsystem::read_grammar;
using lsystem::Redefinition;
using lsystem::text_of;
using lsystem::Word;

// Grammars that come with the program, by name: "abop-a" and so on.
struct NamedGrammar {
    std::string_view name;
    std::string_view text;
};
const std::vector<NamedGrammar>& grammar_library();
// One of them; throws InputError naming those there are.
Grammar library_grammar(std::string_view name, std::span<const Redefinition> instead = {});

}  // namespace quadrat::synthesis::trees
