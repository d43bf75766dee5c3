// SPDX-License-Identifier: Apache-2.0
// What may answer at a projector's address, and what cec-ctl may print: it is understood or refused in words.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "projector/cec.hpp"
#include "projector/pjlink.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat::projector;
    const std::string text(reinterpret_cast<const char*>(bytes), size);
    const auto is_said_in_words = [](const Trouble& trouble) {
        for (const char c : std::string(trouble.what()))
            if (c < ' ' || c == 127) std::abort();
        if (trouble.remedy().empty()) std::abort();
    };
    try {
        const std::string challenge = challenge_of(text);
        if (!challenge.empty() && challenge.size() != 8) std::abort();
    } catch (const Trouble& trouble) {
        is_said_in_words(trouble);
    }
    try {
        if (const auto answer = answer_from(text, "POWR")) power_from(*answer);
    } catch (const Trouble& trouble) {
        is_said_in_words(trouble);
    }
    ailments_from(text);
    power_in(text);
    const std::string place = physical_address_in(text);
    if (!place.empty() && place.size() != 7) std::abort();
    try {
        if (parse_address(to_text(parse_address(text))) != parse_address(text)) std::abort();
    } catch (const std::invalid_argument&) {
    }
    return 0;
}
