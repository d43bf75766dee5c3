// SPDX-License-Identifier: Apache-2.0
// Any bytes as a translator's file: a language that can be spoken, one whose texts are told to be wrong, or no PO.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "genome/json_text.hpp"
#include "genome/language_po.hpp"
#include "genome/speech.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat;
    try {
        const std::string json = genome::json_of_po({reinterpret_cast<const char*>(bytes), size}, "input");
        const auto read = genome::parse_json(json, "what was made of it");
        if (!read.is_object()) std::abort();
        const genome::Language language = genome::Language::from_json(json, "input");
        for (const genome::Word& word : genome::vocabulary())
            if (language.end(word.id, true).empty()) std::abort();
    } catch (const base::InputError& error) {
        if (std::string_view(error.what()).empty()) std::abort();
    }
    return 0;
}
