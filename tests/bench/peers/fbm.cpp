// SPDX-License-Identifier: Apache-2.0
// A height field of eight octaves of gradient noise on one thread. libnoise knows noise in space only: twice the
// corners.
#include "bench/peers/peers.hpp"
#include "bench/peers/plain_fbm.hpp"
#include "synthesis/land/field_methods.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#ifdef QUADRAT_HAS_LIBNOISE
#include <libnoise/noise.h>
#endif

namespace quadrat::peers {
namespace {

using synthesis::land::FieldRequest;

constexpr int kOctaves = 8;
constexpr float kFeatures = 2.5F;

template <typename At>
mesh::Field by_samples(int size, const At& at) {
    mesh::Field field(size, size);
    const float scale = kFeatures / static_cast<float>(size - 1);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
            field.at(column, row) = at(static_cast<float>(column) * scale, static_cast<float>(row) * scale);
    return field;
}

#ifdef QUADRAT_HAS_LIBNOISE
constexpr const char* kWhyNot = "";

mesh::Field by_libnoise(int size) {
    ::noise::module::Perlin perlin;
    perlin.SetOctaveCount(kOctaves);
    return by_samples(size, [&](float x, float y) { return static_cast<float>(perlin.GetValue(x, y, 0.5)); });
}
#else
constexpr const char* kWhyNot = "built without libnoise-dev";

mesh::Field by_libnoise(int) { return {}; }
#endif

}  // namespace

std::vector<Row> fbm(const Options& how) {
    const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
    const int size = how.is_quick ? 257 : 1025;
    FieldRequest request;
    request.size = size;
    request.octaves = kOctaves;
    request.features = kFeatures;
    request.seed = base::Seed{5};
    const PlainFbm plain{base::Seed{5}};
    float last = 0;  // what nobody reads need not be made
    const auto timed = [&](const auto& make) { return own_ms([&] { last += make().samples.back(); }); };
    const auto ours = [&] { return timed([&] { return synthesis::land::field_method("fbm")->make(request); }); };
    const auto libnoise = [&] { return timed([&] { return by_libnoise(size); }); };
    const auto scalar = [&] {
        return timed([&] { return by_samples(size, [&](float x, float y) { return plain.at(x, y, kOctaves); }); });
    };
    const auto beside = [&](Row row, const std::function<double()>& theirs) {
        row.against += fmt::format(", {0} octaves, {1} x {1} samples", kOctaves, size);
        if (is_asked(how, row.name)) row.turns = in_turns(how.turns, ours, row.why.empty() ? theirs : nullptr);
        return row;
    };
    Row of_libnoise{"fbm", "ms", "libnoise", 1.0 / 12};
    of_libnoise.why = kWhyNot;
    return {beside(of_libnoise, libnoise), beside({"fbm_plain", "ms", "plain scalar code", {}}, scalar)};
}

}  // namespace quadrat::peers
