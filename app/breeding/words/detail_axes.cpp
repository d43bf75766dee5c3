// SPDX-License-Identifier: Apache-2.0
#include "breeding/words/detail_axes.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "breeding/words/axes_texts.hpp"
#include "genome/json_text.hpp"

namespace quadrat::breeding {
namespace {

using genome::Aspect;
using genome::brief;
using genome::member;
using nlohmann::json;

constexpr double kLeastSpread = 0.04;   // of a range: nothing is known exactly
constexpr double kLeastPart = 0.08;     // of an axis; what is smaller nobody would tell from it
constexpr double kLeastVisible = 0.02;  // of the first axis' share of the picture

Eigen::VectorXd vector_of(const Point& point) {
    return Eigen::Map<const Eigen::VectorXd>(point.data(), static_cast<Eigen::Index>(point.size()));
}

Eigen::MatrixXd mean_gram(std::span<const PictureJacobian> pictures, Eigen::Index n) {
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(n, n);
    for (const PictureJacobian& jacobian : pictures) {
        const Eigen::MatrixXd wide = jacobian.cast<double>();
        gram += wide * wide.transpose() / static_cast<double>(pictures.size());
    }
    return gram;
}

std::map<genome::ParameterId, double> parts_of(const Eigen::VectorXd& axis, const Atlas& atlas) {
    std::map<genome::ParameterId, double> parts;
    for (Eigen::Index p = 0; p < axis.size(); ++p)
        if (std::abs(axis[p]) >= kLeastPart) parts[atlas.ids[static_cast<std::size_t>(p)]] = axis[p];
    return parts;
}

std::string parts_json(const std::map<genome::ParameterId, double>& parts) {
    std::string text;
    for (const auto& [id, part] : parts)
        text += fmt::format(R"({}"{}":{:.4f})", text.empty() ? "" : ",", parameter(id).name, part);
    return "{" + text + "}";
}

std::map<genome::ParameterId, double> parts_from(const json& value, Aspect aspect, std::string_view source,
                                                 std::string_view place) {
    if (!value.is_object()) throw base::InputError(fmt::format("{}: {} should be an object", source, place));
    std::map<genome::ParameterId, double> parts;
    for (const auto& [name, number] : value.items()) {
        if (!number.is_number())
            throw base::InputError(
                fmt::format("{}: {}.{} is {}; it should be a number", source, place, name, brief(number)));
        const auto id = genome::parameter_named(name);
        if (id && parameter(*id).aspect == aspect) parts[*id] = number.get<double>();
    }
    return parts;
}

}  // namespace

DetailAxes detail_axes(const WordMap& map, Aspect aspect, std::span<const PictureJacobian> pictures,
                       std::size_t count) {
    const Atlas& atlas = map.atlas(aspect);
    const auto n = static_cast<Eigen::Index>(atlas.ids.size());
    const Eigen::MatrixXd gram = mean_gram(pictures, n);
    Eigen::MatrixXd left = Eigen::MatrixXd::Identity(n, n);  // beside words
    for (std::size_t a = 0; a < atlas.word_axes; ++a)
        left -= vector_of(atlas.axes[a]) * vector_of(atlas.axes[a]).transpose();
    Eigen::VectorXd spread(n);
    DetailAxes axes;
    const double mean = gram.diagonal().cwiseSqrt().mean();
    for (Eigen::Index p = 0; p < n; ++p) {
        const genome::ParameterId id = atlas.ids[static_cast<std::size_t>(p)];
        axes.seen[id] = mean > 0 ? std::sqrt(gram(p, p)) / mean : 0;
        const bool is_choice = parameter(id).unit == genome::kChoice;
        spread[p] = is_choice ? 0 : std::max(kLeastSpread, map.spread(id));
    }
    const Eigen::MatrixXd weighed = spread.asDiagonal() * left * gram * left * spread.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(weighed);
    const double most = solver.eigenvalues()[n - 1];
    for (Eigen::Index k = n - 1; k >= 0 && axes.axes.size() < count; --k) {
        if (solver.eigenvalues()[k] < kLeastVisible * most) break;
        const Eigen::VectorXd axis = left * spread.asDiagonal() * solver.eigenvectors().col(k);
        axes.axes.push_back(parts_of(axis.normalized(), atlas));
    }
    return axes;
}

std::string to_json(const DetailAxes& axes, Aspect aspect) {
    std::string list;
    for (const auto& axis : axes.axes) list += (list.empty() ? "\n" : ",\n") + parts_json(axis);
    return fmt::format(
        "{{\"quadrat\":\"detail axes\",\"version\":1,\"aspect\":\"{}\",\n\"seen\":{},\n\"axes\":[{}]}}\n",
        name_of(aspect), parts_json(axes.seen), list);
}

DetailAxes detail_axes_from(std::string_view text, std::string_view source, Aspect aspect) {
    const json root = genome::parse_json(text, source);
    genome::require_object(root, {"quadrat", "version", "aspect", "seen", "axes"}, source, "the file");
    if (member(root, "quadrat", source) != "detail axes" || member(root, "version", source) != 1)
        throw base::InputError(fmt::format(
            R"({}: should begin {{"quadrat":"detail axes","version":1,…}}: another kind or version)", source));
    if (member(root, "aspect", source) != std::string(name_of(aspect)))
        throw base::InputError(
            fmt::format("{}: aspect is {}; it should be {}", source, brief(root["aspect"]), name_of(aspect)));
    DetailAxes axes;
    axes.seen = parts_from(member(root, "seen", source), aspect, source, "seen");
    for (const auto& [id, seen] : axes.seen)
        if (seen < 0)
            throw base::InputError(
                fmt::format("{}: seen.{} is {}; it should be at least 0", source, parameter(id).name, seen));
    const json& list = member(root, "axes", source);
    if (!list.is_array()) throw base::InputError(fmt::format("{}: axes should be a list", source));
    for (std::size_t a = 0; a < list.size(); ++a)
        axes.axes.push_back(parts_from(list[a], aspect, source, fmt::format("axes[{}]", a)));
    return axes;
}

const DetailAxes& measured_axes(Aspect aspect) {
    static const genome::PerAspect<DetailAxes> kMeasured = [] {
        genome::PerAspect<DetailAxes> measured;
        for (const base::EmbeddedText& text : axes_texts())
            if (const auto of = genome::aspect_named(text.name))
                measured[*of] = detail_axes_from(text.text, fmt::format("axes/{}.json", text.name), *of);
        return measured;
    }();
    return kMeasured[aspect];
}

}  // namespace quadrat::breeding
