// SPDX-License-Identifier: Apache-2.0
// A first byte n, a descriptor of the next n bytes (times four), then reports of sixteen bytes.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "firmware-io/hid/bindings.hpp"
#include "firmware-io/hid/report_reader.hpp"

using namespace quadrat::firmware_io::hid;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    if (size == 0) return 0;
    std::span<const std::uint8_t> rest{bytes + 1, size - 1};
    const std::size_t length = std::min<std::size_t>(rest.size(), std::size_t{bytes[0]} * 4);
    ReportReader reader{parse_descriptor(rest.first(length))};
    for (const Binding& binding : default_bindings(reader.layout()))
        if (!can_send(reader.layout(), binding.signal)) std::abort();
    for (rest = rest.subspan(length); !rest.empty(); rest = rest.subspan(std::min<std::size_t>(16, rest.size()))) {
        reader.read(rest.first(std::min<std::size_t>(16, rest.size())));
        for (const HidSignal& signal : reader.pressed())
            if (!can_send(reader.layout(), signal)) std::abort();
    }
    return 0;
}
