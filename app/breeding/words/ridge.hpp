// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace quadrat::breeding {

// Least squares with a ridge for each basis function, chosen by generalised cross-validation (Orr 1996, "Introduction
// to radial basis function networks", sections 6.3 and 7.2): with design H, examples weighted by W, A = H'WH + Λ,
//     w = A⁻¹H'Wy      P = I - W½HA⁻¹H'W½      GCV = p |P W½y|² / tr(P)²
// A basis function whose best ridge is infinite is needless and has weight 0. The constant is never shrunk.
struct RidgeFit {
    std::vector<double> weights;
    std::vector<double> ridges;  // infinity where dropped
    double gcv = 0;
    double leave_one_out = 0;  // root mean square, weighted; of each example told from the others with these ridges
};

class RidgeRegression {
  public:
    // One row of design an example. Weights are positive; constant is the column of ones.
    RidgeRegression(const Eigen::MatrixXd& design, std::span<const double> weights, std::size_t constant);

    RidgeFit fit(std::span<const double> targets) const;

    // For ridges given: what fit() ends with.
    RidgeFit with_ridges(std::span<const double> targets, std::span<const double> ridges) const;

  private:
    struct System;  // one fit under way

    System begun(std::span<const double> targets) const;
    RidgeFit finished(const System& system) const;

    Eigen::MatrixXd design_;  // rows times the root of their weight
    Eigen::VectorXd root_weights_;
    Eigen::MatrixXd gram_;  // design'design
    Eigen::Index constant_;
};

}  // namespace quadrat::breeding
