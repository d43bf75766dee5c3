// SPDX-License-Identifier: Apache-2.0
#include "display/kms/edid.hpp"

#include <cstdlib>

// Bytes from a screen or its cable: whatever they are, they are read or refused, and what is read is bounded.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::span<const std::uint8_t> given{bytes, size};
    const auto edid = quadrat::display::read_edid(given);
    if (edid && (edid->name.size() > 13 || edid->serial_text.size() > 13 || edid->faults.size() > 300)) std::abort();
    if (quadrat::display::identity_of(edid).empty()) std::abort();
    if ((quadrat::display::fingerprint_of(given) == 0) != (size == 0)) std::abort();
    return 0;
}
