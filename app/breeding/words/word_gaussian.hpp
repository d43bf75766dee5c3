// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "breeding/words/basis.hpp"

namespace quadrat::breeding {

// How words go together in what people describe: a Gaussian over the words of an aspect, from which those that are
// left out follow. Missing words of a description are filled in turn with what the Gaussian of the rest expects.
class WordGaussian {
  public:
    // Without examples: mean 0, no word tells of another.
    explicit WordGaussian(std::size_t dimensions);

    // Each point with its weight. Few examples say little: they are joined by a prior worth as many as there are words.
    WordGaussian(std::span<const Point> points, std::span<const double> weights, std::size_t dimensions);

    std::size_t dimensions() const { return mean_.size(); }
    const Point& mean() const { return mean_; }

    // What it becomes when direction·x is seen to be value, give or take deviation.
    WordGaussian given(std::span<const double> direction, double value, double deviation) const;
    WordGaussian given(std::size_t word, double value) const;

    double covariance(std::size_t i, std::size_t j) const { return covariance_[i * dimensions() + j]; }

  private:
    Point mean_;
    std::vector<double> covariance_;
};

}  // namespace quadrat::breeding
