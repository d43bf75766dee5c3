// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace quadrat::genome {

// What a visitor judges, in the order of the questions, which is the order of cost of growing.
enum class Aspect { Trees, Land, Sky };
inline constexpr std::array kAspects{Aspect::Trees, Aspect::Land, Aspect::Sky};

std::string_view name_of(Aspect aspect);  // "trees", "land", "sky"
std::optional<Aspect> aspect_named(std::string_view name);

// One value for each aspect.
template <typename T>
struct PerAspect {
    std::array<T, kAspects.size()> each{};

    T& operator[](Aspect aspect) { return each[static_cast<std::size_t>(aspect)]; }
    const T& operator[](Aspect aspect) const { return each[static_cast<std::size_t>(aspect)]; }
    friend bool operator==(const PerAspect&, const PerAspect&) = default;
};

}  // namespace quadrat::genome
