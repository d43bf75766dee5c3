// SPDX-License-Identifier: Apache-2.0
#include "site/broker_address.hpp"

#include <cstdint>
#include <cstdlib>
#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace quadrat::site;
    const std::string_view text{reinterpret_cast<const char*>(bytes), size};
    try {
        const Broker broker = parse_broker(text);
        if (broker.host.empty() || broker.port < 1 || broker.port > 65535) std::abort();
        for (const char c : broker.host)
            if (c <= ' ' || c == '@' || c == '/' || c >= '\x7f') std::abort();
        if (parse_broker((broker.is_encrypted ? "mqtts://" : "mqtt://") + to_text(broker)) != broker) std::abort();
    } catch (const std::invalid_argument& error) {
        const std::string_view message{error.what()};
        // What it says is of a few fixed sentences: nothing of what was written gets into a log.
        if (message.find('\n') != std::string_view::npos || message.find("HOST:PORT") == std::string_view::npos)
            std::abort();
    }
    return 0;
}
