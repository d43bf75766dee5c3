// SPDX-License-Identifier: Apache-2.0
// The line protocol: every line in gives one line of JSON out, whatever it holds.
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "breeding/stdio_protocol.hpp"

// Training takes longer under the sanitizers than one input may.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
    quadrat::breeding::default_word_map();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat;
    // Of odd length: bred in words.
    breeding::BreederOptions options;
    if (size % 2 == 1) {
        options.kind = breeding::BreederKind::Belief;
        options.genome = genome::Genome::Full;
    }
    breeding::StdioProtocol protocol(breeding::Session(breeding::Breeder(options), base::Seed{7}));
    std::string_view rest(reinterpret_cast<const char*>(bytes), size);
    while (!rest.empty()) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(line.size() < rest.size() ? line.size() + 1 : rest.size());
        const auto answer = protocol.answer(line);
        if (!answer) return line.find("quit") == std::string_view::npos ? std::abort(), 0 : 0;
        if (answer->find('\n') != std::string::npos || !nlohmann::json::accept(*answer)) std::abort();
    }
    return 0;
}
