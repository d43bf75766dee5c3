// SPDX-License-Identifier: Apache-2.0
// Any text is a grammar or is refused with its line and column; a grammar is derived within its budget.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "synthesis/trees/grammar.hpp"
#include "synthesis/trees/turtle.hpp"

namespace trees = quadrat::synthesis::trees;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const trees::Grammar grammar = trees::read_grammar({reinterpret_cast<const char*>(data), size}, "fuzz");
        trees::DeriveOptions options;
        options.steps = std::min(grammar.steps, 12);
        options.most_symbols = 3000;
        const trees::Derivation derived = trees::derive(grammar, options);
        for (const float value : derived.word.values)
            if (!std::isfinite(value)) std::abort();
        const trees::TreeSkeleton skeleton =
            trees::interpret(derived.word, trees::options_of(grammar), quadrat::base::Seed{1});
        for (const trees::Limb& limb : skeleton.limbs)
            if (limb.nodes.size() < 2 || !std::isfinite(limb.nodes.back().at_m.x)) std::abort();
    } catch (const quadrat::base::InputError& error) {
        if (std::string_view(error.what()).find("fuzz:") != 0) std::abort();
    }
    return 0;
}
