// SPDX-License-Identifier: Apache-2.0
// Split grammars (Wonka, Wimmer, Sillion & Ribarsky 2003) with the absolute and relative sizes, repeats, occlusion and
// snap lines of CGA shape (Müller, Wonka, Haegler, Ulmer & Van Gool 2006). Choices are drawn once for a house, as
// Wonka's control grammar spreads them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/common.hpp>

#include "base/error.hpp"
#include "synthesis/houses/facade_rules.hpp"

namespace quadrat::synthesis::houses {
namespace {

constexpr int kDeepest = 64;
constexpr std::size_t kMostPanels = 20'000;
constexpr int kMostShapes = 400'000;
constexpr double kSlack_m = 1.0e-9;

struct Shape {
    glm::dvec2 low, high;
    double depth_m = 0;
};

class Derivation {
  public:
    Derivation(const FacadeGrammar& grammar, const FacadeShape& facade, base::Seed seed)
        : grammar_(grammar), facade_(facade) {
        for (std::size_t i = 0; i < grammar.rules->choices.size(); ++i) {
            const Choice& choice = grammar.rules->choices[i];
            chosen_[choice.name] = drawn(choice, seed.child(choice.name));
        }
        const Shape whole{{0, 0}, {facade.width_m, facade.height_m + facade.gable_m}, 0};
        for (const auto& [name, expression] : grammar.rules->numbers) numbers_[name] = value(expression, whole);
        derive("Facade", whole, 0, {1, 1});
    }
    std::vector<FacadePanel> panels;

  private:
    static std::string drawn(const Choice& choice, base::Seed seed) {
        double whole = 0;
        for (const auto& [word, weight] : choice.words) whole += weight;
        double left = base::RandomStream{seed}.unit() * whole;
        for (const auto& [word, weight] : choice.words) {
            if (left < weight) return word;
            left -= weight;
        }
        return choice.words.back().first;
    }

    double value(const Expression& expression, const Shape& shape) const {
        std::vector<double> stack;
        for (const Expression::Part& part : expression.parts) {
            if (part.kind == 'n') {
                stack.push_back(part.number);
            } else if (part.kind == 'v') {
                stack.push_back(part.name == "width"    ? shape.high.x - shape.low.x
                                : part.name == "height" ? shape.high.y - shape.low.y
                                : part.name == "front"  ? (facade_.is_front ? 1.0 : 0.0)
                                                        : numbers_.at(part.name));
            } else if (part.kind == '~') {
                stack.back() = -stack.back();
            } else {
                const double right = stack.back();
                stack.pop_back();
                double& left = stack.back();
                if (part.kind == '/' && right == 0) refuse_at(grammar_.source, part.place, "this divides by 0");
                left = part.kind == '+'   ? left + right
                       : part.kind == '-' ? left - right
                       : part.kind == '*' ? left * right
                                          : left / right;
            }
        }
        return stack.empty() ? 0 : stack.back();
    }

    bool holds(const Condition& condition, const Shape& shape) const {
        if (!condition.choice.empty()) return chosen_.at(condition.choice) == condition.word;
        const double left = value(condition.left, shape);
        const double right = value(condition.right, shape);
        if (condition.comparison == "<") return left < right;
        if (condition.comparison == ">") return left > right;
        return condition.comparison == "<=" ? left <= right : left >= right;
    }

    void derive(const std::string& symbol, const Shape& shape, int depth, Place from) {
        if (symbol.empty() || shape.high.x - shape.low.x < kSlack_m || shape.high.y - shape.low.y < kSlack_m) return;
        for (const Rule& rule : grammar_.rules->rules) {
            if (rule.symbol != symbol) continue;
            if (!std::all_of(rule.conditions.begin(), rule.conditions.end(),
                             [&](const Condition& condition) { return holds(condition, shape); }))
                continue;
            if (++shapes_ > kMostShapes)
                refuse_at(grammar_.source, rule.place, fmt::format("more than {} shapes", kMostShapes));
            if (depth > kDeepest) refuse_at(grammar_.source, rule.place, fmt::format("{} goes on for ever", symbol));
            apply(rule, shape, depth + 1);
            return;
        }
        refuse_at(grammar_.source, from,
                  fmt::format("no rule for {} holds of a shape {:.2f} m wide and {:.2f} m high", symbol,
                              shape.high.x - shape.low.x, shape.high.y - shape.low.y));
    }

    void apply(const Rule& rule, const Shape& shape, int depth) {
        switch (rule.kind) {
            case Rule::Kind::Split:
                return split(rule, shape, depth);
            case Rule::Kind::Repeat:
                return repeat(rule, shape, depth);
            case Rule::Kind::Inset:
                return inset(rule, shape, depth);
            case Rule::Kind::Free:
                return derive(is_free(shape) ? rule.then : rule.otherwise, shape, depth, rule.place);
            case Rule::Kind::Panel:
                return panel(rule, shape, depth);
            case Rule::Kind::Nothing:
                return;
        }
    }

    void split(const Rule& rule, const Shape& shape, int depth) {
        const double whole = shape.high[rule.axis] - shape.low[rule.axis];
        double fixed = 0;
        double shares = 0;
        std::vector<double> sizes;
        for (const SplitPart& part : rule.parts) {
            sizes.push_back(std::max(0.0, value(part.size, shape)));
            (part.is_relative ? shares : fixed) += sizes.back();
        }
        const double squeeze = fixed > whole ? whole / fixed : 1;
        double at = shape.low[rule.axis];
        for (std::size_t i = 0; i < rule.parts.size(); ++i) {
            const double size =
                rule.parts[i].is_relative ? std::max(0.0, whole - fixed) * sizes[i] / shares : squeeze * sizes[i];
            if (!std::isfinite(size)) refuse_at(grammar_.source, rule.place, "parts that have no size, or no end");
            Shape part = shape;
            part.low[rule.axis] = at;
            at += size;
            part.high[rule.axis] = std::min(at, shape.high[rule.axis]);
            if (rule.is_marking && i > 0) marks_[static_cast<std::size_t>(rule.axis)].push_back(part.low[rule.axis]);
            derive(rule.parts[i].symbol, part, depth, rule.place);
        }
    }

    void repeat(const Rule& rule, const Shape& shape, int depth) {
        const double size = value(rule.parts[0].size, shape);
        if (!(size > 1.0e-3)) refuse_at(grammar_.source, rule.place, fmt::format("repeats of {} m", size));
        std::vector<double> ends{shape.low[rule.axis]};
        if (rule.is_snapping) {
            std::vector<double> marks = marks_[static_cast<std::size_t>(rule.axis)];
            std::sort(marks.begin(), marks.end());
            for (const double mark : marks)
                if (mark > ends.back() + 0.3 * size && mark < shape.high[rule.axis] - 0.3 * size) ends.push_back(mark);
        }
        ends.push_back(shape.high[rule.axis]);
        for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
            const double length = ends[k + 1] - ends[k];
            const auto count = static_cast<int>(std::clamp(std::round(length / size), 1.0, 10'000.0));
            for (int i = 0; i < count; ++i) {
                Shape part = shape;
                part.low[rule.axis] = ends[k] + length * i / count;
                part.high[rule.axis] = ends[k] + length * (i + 1) / count;
                derive(rule.parts[0].symbol, part, depth, rule.place);
            }
        }
    }

    void inset(const Rule& rule, const Shape& shape, int depth) {
        Shape part = shape;
        part.low += glm::dvec2(value(rule.insets[0], shape), value(rule.insets[1], shape));
        part.high -= glm::dvec2(value(rule.insets[2], shape), value(rule.insets[3], shape));
        derive(rule.then, part, depth, rule.place);
    }

    double roof_at(double x) const {
        const double half = 0.5 * facade_.width_m;
        return facade_.height_m + facade_.gable_m * std::max(0.0, 1 - std::abs(x - half) / half);
    }

    bool is_free(const Shape& shape) const {
        if (shape.low.x < -kSlack_m || shape.low.y < -kSlack_m || shape.high.x > facade_.width_m + kSlack_m)
            return false;
        if (shape.high.y > std::min(roof_at(shape.low.x), roof_at(shape.high.x)) + kSlack_m) return false;
        return std::none_of(facade_.covered.begin(), facade_.covered.end(),
                            [&shape](const FacadeShape::Covered& covered) {
                                return shape.low.x < covered.high_m.x && covered.low_m.x < shape.high.x &&
                                       shape.low.y < covered.high_m.y && covered.low_m.y < shape.high.y;
                            });
    }

    void panel(const Rule& rule, const Shape& shape, int depth) {
        if (panels.size() >= kMostPanels)
            refuse_at(grammar_.source, rule.place, fmt::format("more than {} panels", kMostPanels));
        const std::string& colour = rule.colour[0] == '#' ? rule.colour : chosen_.at(rule.colour);
        std::array<int, 3> parts{};
        for (std::size_t i = 0; i < 3; ++i) std::from_chars(&colour[1 + 2 * i], &colour[3 + 2 * i], parts[i], 16);
        Shape on = shape;
        on.depth_m += value(rule.depth, shape);
        panels.push_back({shape.low, shape.high, on.depth_m, shape.depth_m,
                          glm::vec3(parts[0], parts[1], parts[2]) / 255.0F, rule.symbol});
        derive(rule.then, on, depth, rule.place);
    }

    const FacadeGrammar& grammar_;
    const FacadeShape& facade_;
    int shapes_ = 0;
    std::map<std::string, std::string> chosen_;
    std::map<std::string, double> numbers_;
    std::array<std::vector<double>, 2> marks_;
};

float linear_of(float s) { return s <= 0.04045F ? s / 12.92F : std::pow((s + 0.055F) / 1.055F, 2.4F); }

void add_quad(mesh::Mesh& mesh, std::array<glm::vec3, 4> corners, glm::vec3 normal) {
    const auto first = static_cast<std::uint32_t>(mesh.positions_m.size());
    for (const glm::vec3& corner : corners) {
        mesh.positions_m.push_back(corner);
        mesh.normals.push_back(normal);
    }
    for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + i);
}

void add_panel(mesh::Mesh& mesh, const FacadePanel& panel, int layer) {
    const glm::vec2 a(panel.low_m);
    const glm::vec2 b(panel.high_m);
    const auto front = static_cast<float>(panel.depth_m) + 1.0e-4F * static_cast<float>(layer);
    const auto back = static_cast<float>(panel.depth_from_m);
    add_quad(mesh, {{{a.x, a.y, front}, {b.x, a.y, front}, {b.x, b.y, front}, {a.x, b.y, front}}}, {0, 0, 1});
    if (panel.depth_m == panel.depth_from_m) return;
    const float out = panel.depth_m > panel.depth_from_m ? 1.0F : -1.0F;
    const float near = out > 0 ? front : back;
    const float far = out > 0 ? back : front;
    const auto side = [&](glm::vec2 p, glm::vec2 q, glm::vec3 normal) {
        if (out < 0) std::swap(p, q);
        add_quad(mesh, {{{p.x, p.y, far}, {q.x, q.y, far}, {q.x, q.y, near}, {p.x, p.y, near}}}, out * normal);
    };
    side(a, {b.x, a.y}, {0, -1, 0});
    side({b.x, a.y}, b, {1, 0, 0});
    side(b, {a.x, b.y}, {0, 1, 0});
    side({a.x, b.y}, a, {-1, 0, 0});
}

}  // namespace

std::vector<FacadePanel> derive_facade(const FacadeGrammar& grammar, const FacadeShape& shape, base::Seed seed) {
    return std::move(Derivation(grammar, shape, seed).panels);
}

mesh::Model facade_model(const std::vector<FacadePanel>& panels) {
    mesh::Model model;
    std::vector<glm::vec3> colours;
    int layer = 0;
    for (const FacadePanel& panel : panels) {
        std::size_t part = 0;
        while (part < colours.size() && colours[part] != panel.colour) ++part;
        if (part == colours.size()) {
            colours.push_back(panel.colour);
            const glm::vec3 linear(linear_of(panel.colour.r), linear_of(panel.colour.g), linear_of(panel.colour.b));
            model.parts.push_back({fmt::format("panel{}", part), {}, linear});
        }
        add_panel(model.parts[part].mesh, panel, layer++ % 8);
    }
    return model;
}

}  // namespace quadrat::synthesis::houses
