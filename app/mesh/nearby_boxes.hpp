// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

namespace quadrat::mesh {

struct Box {
    glm::dvec2 low{1.0e300};
    glm::dvec2 high{-1.0e300};

    void include(glm::dvec2 p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    void grow(double by) {
        low -= by;
        high += by;
    }
    bool overlaps(const Box& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
    }
};

// Numbers in boxes, found by where they are: a grid of lists. A number may be entered again with another box; what it
// had before stays, so that whoever asks must look again whether what is found holds.
class NearbyBoxes {
  public:
    NearbyBoxes() = default;
    NearbyBoxes(const Box& domain, std::size_t expected) : domain_(domain) {
        const glm::dvec2 size = glm::max(domain.high - domain.low, glm::dvec2(1.0e-9));
        const double cell = std::sqrt(size.x * size.y / static_cast<double>(std::max<std::size_t>(expected, 1)));
        columns_ = std::clamp(static_cast<int>(size.x / cell), 1, 512);
        rows_ = std::clamp(static_cast<int>(size.y / cell), 1, 512);
        per_cell_ = {columns_ / size.x, rows_ / size.y};
        cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    }

    void clear() {
        for (std::vector<Entry>& list : cells_) list.clear();
        large_.clear();
    }

    void enter(int number, const Box& box) {
        const Span s = span(box);
        if (!(static_cast<std::size_t>(s.columns()) * static_cast<std::size_t>(s.rows()) <= kMostCells)) {
            large_.push_back(number);
            return;
        }
        for (int y = s.y0; y <= s.y1; ++y)
            for (int x = s.x0; x <= s.x1; ++x) cell(x, y).push_back({box, number});
    }

    // Calls f(number) once for each whose box may overlap. What f says false of is forgotten.
    template <typename F>
    void each(const Box& box, F&& f) {
        ++query_;
        const auto is_new = [this](int number) {
            const auto at = static_cast<std::size_t>(number);
            if (at >= asked_.size()) asked_.resize(2 * at + 64, 0);
            return std::exchange(asked_[at], query_) != query_;
        };
        const auto forget = [&](auto& list, const auto& is_met, const auto& number_of) {
            for (std::size_t i = 0; i < list.size();) {
                if (is_met(list[i]) && is_new(number_of(list[i])) && !f(number_of(list[i]))) {
                    list[i] = list.back();
                    list.pop_back();
                } else {
                    ++i;
                }
            }
        };
        forget(
            large_, [](int) { return true; }, [](int number) { return number; });
        const Span s = span(box);
        for (int y = s.y0; y <= s.y1; ++y)
            for (int x = s.x0; x <= s.x1; ++x)
                forget(
                    cell(x, y), [&box](const Entry& e) { return e.box.overlaps(box); },
                    [](const Entry& e) { return e.number; });
    }

  private:
    static constexpr std::size_t kMostCells = 64;
    struct Entry {
        Box box;
        int number;
    };
    struct Span {
        int x0, y0, x1, y1;
        int columns() const { return x1 - x0 + 1; }
        int rows() const { return y1 - y0 + 1; }
    };

    std::vector<Entry>& cell(int x, int y) {
        return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)];
    }
    Span span(const Box& box) const {
        const auto at = [](double place, int count) {
            return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(count - 1)));
        };
        return {at((box.low.x - domain_.low.x) * per_cell_.x, columns_),
                at((box.low.y - domain_.low.y) * per_cell_.y, rows_),
                at((box.high.x - domain_.low.x) * per_cell_.x, columns_),
                at((box.high.y - domain_.low.y) * per_cell_.y, rows_)};
    }

    Box domain_;
    int columns_ = 1, rows_ = 1;
    glm::dvec2 per_cell_{1};
    std::vector<std::vector<Entry>> cells_ = std::vector<std::vector<Entry>>(1);
    std::vector<int> large_;
    std::vector<std::uint32_t> asked_;  // the last query that met each number
    std::uint32_t query_ = 0;
};

}  // namespace quadrat::mesh
