// SPDX-License-Identifier: Apache-2.0
// The rational function in the ridge of one basis function, all others held, is Orr's (1996, section 6.3); it is
// evaluated here from m × m matrices alone, so that a cycle over all m costs m³ whatever the number of examples.
#include "breeding/words/ridge.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace quadrat::breeding {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// People disagree: no function may follow a single description exactly. In units of a function's own sum of squares.
constexpr double kSmallestRidge = 0.02;
constexpr double kConstantRidge = 1e-9;
constexpr int kMostCycles = 8;
constexpr double kSettled = 1e-4;  // relative change of GCV in a cycle

}  // namespace

struct RidgeRegression::System {
    Eigen::VectorXd targets;  // times the root of their weight
    Eigen::MatrixXd inverse;  // A⁻¹; a row and column of zeros where a function is dropped
    Eigen::VectorXd moments;  // H'Wy
    double squares = 0;       // y'Wy
    double examples = 0;
    std::vector<double> ridges;

    double gcv(const Eigen::MatrixXd& gram) const {
        const Eigen::VectorXd w = inverse * moments;
        const double residual = std::max(0.0, squares - 2 * w.dot(moments) + w.dot(gram * w));
        const double trace = examples - inverse.cwiseProduct(gram).sum();
        return examples * residual / (trace * trace);
    }

    // A⁻¹ without function j: what it tends to as the ridge grows.
    void drop(Eigen::Index j) {
        if (std::isinf(ridges[static_cast<std::size_t>(j)])) return;
        const Eigen::VectorXd column = inverse.col(j);
        inverse.noalias() -= column * (column.transpose() / column[j]);
        inverse.row(j).setZero();
        inverse.col(j).setZero();
        ridges[static_cast<std::size_t>(j)] = kInfinity;
    }

    // Function j, dropped until now, with a ridge; schur = h'P_j h without it, others = A_j⁻¹H'Wh.
    void take(Eigen::Index j, double ridge, double schur, const Eigen::VectorXd& others) {
        if (std::isinf(ridge)) return;
        Eigen::VectorXd direction = -others;
        direction[j] = 1;
        inverse.noalias() += direction * (direction.transpose() / (ridge + schur));
        ridges[static_cast<std::size_t>(j)] = ridge;
    }

    void choose(Eigen::Index j, const Eigen::MatrixXd& gram);
};

// With Δ = λ + h'P_j h:  GCV(λ) = p (aΔ² - 2bΔ + c) / (αΔ - β)², least at its one stationary point, at the smallest
// ridge allowed, or at infinity.
void RidgeRegression::System::choose(Eigen::Index j, const Eigen::MatrixXd& gram) {
    drop(j);
    const Eigen::VectorXd g = gram.col(j);
    const Eigen::VectorXd u = inverse * g;
    const double schur = g[j] - u.dot(g);
    if (!(schur > 1e-12 * g[j])) return;  // the others span it
    const Eigen::VectorXd v = inverse * moments;
    const Eigen::VectorXd gram_u = gram * u;
    const double beta = std::max(0.0, g[j] - 2 * u.dot(g) + u.dot(gram_u));
    const double yph = moments[j] - u.dot(moments);
    const double ypph = moments[j] - u.dot(moments) - v.dot(g) + v.dot(gram_u);
    const double a = std::max(0.0, squares - 2 * v.dot(moments) + v.dot(gram * v));
    const double b = ypph * yph;
    const double c = beta * yph * yph;
    const double alpha = examples - inverse.cwiseProduct(gram).sum();
    const auto score = [&](double delta) {
        const double trace = alpha * delta - beta;
        return (a * delta * delta - 2 * b * delta + c) / (trace * trace);
    };
    double best = kInfinity;
    double least = a / (alpha * alpha);
    const double smallest = kSmallestRidge * g[j] + schur;
    const double stationary = (alpha * c - b * beta) / (b * alpha - a * beta);
    for (const double delta : {stationary, smallest}) {
        if (!(delta >= smallest) || !(alpha * delta > beta) || !(score(delta) < least)) continue;
        least = score(delta);
        best = delta - schur;
    }
    take(j, best, schur, u);
}

RidgeRegression::RidgeRegression(const Eigen::MatrixXd& design, std::span<const double> weights, std::size_t constant)
    : design_(design), root_weights_(design.rows()), constant_(static_cast<Eigen::Index>(constant)) {
    assert(static_cast<std::size_t>(design.rows()) == weights.size());
    for (Eigen::Index i = 0; i < design_.rows(); ++i) {
        root_weights_[i] = std::sqrt(weights[static_cast<std::size_t>(i)]);
        design_.row(i) *= root_weights_[i];
    }
    gram_ = design_.transpose() * design_;
}

RidgeRegression::System RidgeRegression::begun(std::span<const double> targets) const {
    assert(targets.size() == static_cast<std::size_t>(design_.rows()));
    const Eigen::Index m = gram_.rows();
    System system;
    system.targets = Eigen::Map<const Eigen::VectorXd>(targets.data(), design_.rows()).cwiseProduct(root_weights_);
    system.inverse = Eigen::MatrixXd::Zero(m, m);
    system.moments = design_.transpose() * system.targets;
    system.squares = system.targets.squaredNorm();
    system.examples = static_cast<double>(design_.rows());
    system.ridges.assign(static_cast<std::size_t>(m), kInfinity);
    return system;
}

RidgeFit RidgeRegression::fit(std::span<const double> targets) const {
    System system = begun(targets);
    const Eigen::Index m = gram_.rows();
    system.take(constant_, kConstantRidge, gram_(constant_, constant_), Eigen::VectorXd::Zero(m));
    double before = system.gcv(gram_);
    for (int cycle = 0; cycle < kMostCycles; ++cycle) {
        // The linear part first, from the last function down: what it explains no Gaussian needs to.
        for (Eigen::Index j = m - 1; j >= 0; --j)
            if (j != constant_ && gram_(j, j) > 0) system.choose(j, gram_);
        const double now = system.gcv(gram_);
        if (before - now <= kSettled * before) break;
        before = now;
    }
    return finished(system);
}

RidgeFit RidgeRegression::with_ridges(std::span<const double> targets, std::span<const double> ridges) const {
    System system = begun(targets);
    for (Eigen::Index j = 0; j < gram_.rows(); ++j) {
        const Eigen::VectorXd u = system.inverse * gram_.col(j);
        system.take(j, ridges[static_cast<std::size_t>(j)], gram_(j, j) - u.dot(gram_.col(j)), u);
    }
    return finished(system);
}

RidgeFit RidgeRegression::finished(const System& system) const {
    const Eigen::VectorXd w = system.inverse * system.moments;
    RidgeFit fit{{w.begin(), w.end()}, system.ridges, system.gcv(gram_), 0};
    const Eigen::VectorXd residual = system.targets - design_ * w;
    const Eigen::MatrixXd smoother = design_ * system.inverse;
    double errors = 0;
    double weights = 0;
    for (Eigen::Index i = 0; i < residual.size(); ++i) {
        const double leverage = std::min(0.999, smoother.row(i).dot(design_.row(i)));
        const double error = residual[i] / (1 - leverage);  // still times the root of the example's weight
        errors += error * error;
        weights += root_weights_[i] * root_weights_[i];
    }
    fit.leave_one_out = weights > 0 ? std::sqrt(errors / weights) : 0;
    return fit;
}

}  // namespace quadrat::breeding
