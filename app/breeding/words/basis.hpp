// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace quadrat::breeding {

using Point = std::vector<double>;  // the words of one aspect, each in [-1, 1]

// What a word map is a sum of: a Gaussian at each of some described scenes, a constant, and the words themselves. The
// linear part is what "Affective scene generation" (2006) lacked: far from all scenes the answer then changes gently
// instead of falling to zero.
class Basis {
  public:
    // Gaussians beyond this buy nothing that people's descriptions could tell apart, and cost the cube of it.
    static constexpr std::size_t kMostCentres = 40;

    Basis() = default;

    // A Gaussian on each point, or on those farthest from one another where there are too many. A radius reaches the
    // point's nearest neighbours, so that all of the space between scenes is covered by several and dense regions are
    // not smeared (the paper's first open end, section 6).
    explicit Basis(std::span<const Point> points);

    std::size_t dimensions() const { return dimensions_; }
    std::size_t gaussians() const { return centres_.size(); }
    std::size_t size() const { return gaussians() + 1 + dimensions_; }  // constant after the Gaussians, then linear

    void evaluate(std::span<const double> at, std::span<double> values) const;  // values.size() == size()

  private:
    std::size_t dimensions_ = 0;
    std::vector<Point> centres_;
    std::vector<double> radii_;
};

}  // namespace quadrat::breeding
