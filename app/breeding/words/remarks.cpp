// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "breeding/words/lessons.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;

constexpr float kAlike = 0.05F;                // of a word: nobody could say it more exactly
constexpr double kApart = 0.25;                // of a parameter's range: one sees it
constexpr std::ptrdiff_t kLooksDifferent = 5;  // parameters that are apart, however many there are

bool are_described_alike(const DescribedScene& a, const DescribedScene& b) {
    for (std::size_t w = 0; w < a.words.size(); ++w) {
        if (a.words[w].has_value() != b.words[w].has_value()) return false;
        if (a.words[w] && std::abs(*a.words[w] - *b.words[w]) > kAlike) return false;
    }
    return true;
}

bool look_different(const DescribedScene& a, const DescribedScene& b, Aspect aspect) {
    const auto apart = std::ranges::count_if(parameters_of(aspect, genome::Genome::Full), [&](genome::ParameterId id) {
        return std::abs(a.values[id] - b.values[id]) > kApart * (parameter(id).max - parameter(id).min);
    });
    return apart >= kLooksDifferent;
}

std::string name_of(const DescribedScene& scene, std::size_t number) {
    return scene.name.empty() ? fmt::format("number {}", number + 1) : fmt::format("\"{}\"", scene.name);
}

void remark_on_contradictions(const std::vector<const DescribedScene*>& scenes, Aspect aspect,
                              std::vector<std::string>& remarks) {
    int pairs = 0;
    std::string first;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (!are_described_alike(*scenes[i], *scenes[j]) || !look_different(*scenes[i], *scenes[j], aspect))
                continue;
            if (pairs++ == 0) first = fmt::format("{} and {}", name_of(*scenes[j], j), name_of(*scenes[i], i));
        }
    if (pairs > 0)
        remarks.push_back(fmt::format("{}: described alike and yet different: {}{}; the map goes between them",
                                      name_of(aspect), first,
                                      pairs > 1 ? fmt::format(", and {} more pairs", pairs - 1) : ""));
}

// How many words the scenes move independently of one another.
Eigen::Index freedom_of(const std::vector<const DescribedScene*>& scenes, Aspect aspect) {
    const auto vocabulary = genome::vocabulary(aspect);
    Eigen::MatrixXd said =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(scenes.size()), static_cast<Eigen::Index>(vocabulary.size()));
    for (Eigen::Index i = 0; i < said.rows(); ++i)
        for (Eigen::Index w = 0; w < said.cols(); ++w)
            said(i, w) = scenes[static_cast<std::size_t>(i)]
                             ->words[static_cast<std::size_t>(vocabulary[static_cast<std::size_t>(w)].id)]
                             .value_or(0);
    said.rowwise() -= said.colwise().mean().eval();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(said);
    qr.setThreshold(1e-3);
    return qr.rank();
}

}  // namespace

std::vector<std::string> remarks_on(std::span<const DescribedScene> scenes) {
    std::vector<std::string> remarks;
    for (const Aspect aspect : genome::kAspects) {
        std::vector<const DescribedScene*> own;
        for (const DescribedScene& scene : scenes)
            if (scene.aspect == aspect) own.push_back(&scene);
        const std::size_t words = genome::vocabulary(aspect).size();
        remark_on_contradictions(own, aspect, remarks);
        if (own.size() < words)
            remarks.push_back(
                fmt::format("{}: {} described scenes for {} words; what they do not tell stays in the "
                            "middle of what they show",
                            name_of(aspect), own.size(), words));
        else if (const auto freedom = static_cast<std::size_t>(freedom_of(own, aspect)); freedom < words)
            remarks.push_back(fmt::format(
                "{}: the scenes move {} of {} words independently; of the others they tell nothing (singular)",
                name_of(aspect), freedom, words));
    }
    return remarks;
}

}  // namespace quadrat::breeding
