// SPDX-License-Identifier: Apache-2.0
// Any bytes as a file of fixed points, and as one of lines: either they are refused in one printable line, or a small
// field meets them and is finite everywhere.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/error.hpp"
#include "synthesis/land/constraint_text.hpp"

namespace {

using namespace quadrat;
using namespace quadrat::synthesis;

void require(bool is_right) {
    if (!is_right) std::abort();
}

void require_one_line(const base::InputError& error) {
    for (const char* c = error.what(); *c != 0; ++c) require(*c >= ' ' && *c <= '~');
}

void meet(const land::FieldRequest& request) {
    if (request.fixed.size() > 64) return;  // slow, and says no more
    const mesh::Field field = land::make_field(*land::field_method("fbm"), request);
    for (const land::FixedPoint& p : request.fixed) require(field.at(p.column, p.row) == p.height);
    for (const float h : field.samples) require(!std::isnan(h));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    land::FieldRequest request;
    request.size = 33;
    request.octaves = 3;
    try {
        request.fixed = land::fixed_points_from(text, "fuzz");
        meet(request);
    } catch (const base::InputError& error) {
        require_one_line(error);
    }
    request.fixed.clear();
    try {
        request.lines = land::lines_from(text, "fuzz");
        std::size_t corners = 0;
        for (const land::Line& line : request.lines) corners += line.corners.size();
        if (corners <= 64) meet(request);
    } catch (const base::InputError& error) {
        require_one_line(error);
    }
    return 0;
}
