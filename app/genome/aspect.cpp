// SPDX-License-Identifier: Apache-2.0
#include "genome/aspect.hpp"

namespace quadrat::genome {

std::string_view name_of(Aspect aspect) {
    static constexpr PerAspect<std::string_view> kNames{{"trees", "land", "sky"}};
    return kNames[aspect];
}

std::optional<Aspect> aspect_named(std::string_view name) {
    for (const Aspect aspect : kAspects)
        if (name_of(aspect) == name) return aspect;
    return std::nullopt;
}

}  // namespace quadrat::genome
