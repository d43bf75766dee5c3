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

    // Kept up to date by rank-one changes: w = A⁻¹H'Wy, H'WHw, and the trace of A⁻¹H'WH.
    Eigen::VectorXd weights;
    Eigen::VectorXd gram_weights;
    double trace = 0;

    void refresh(const Eigen::MatrixXd& gram) {
        weights = inverse * moments;
        gram_weights = gram * weights;
        trace = inverse.cwiseProduct(gram).sum();
    }

    double gcv() const {
        const double residual = std::max(0.0, squares - 2 * weights.dot(moments) + weights.dot(gram_weights));
        return examples * residual / ((examples - trace) * (examples - trace));
    }

    void choose(Eigen::Index j, const Eigen::MatrixXd& gram);
};

// With Δ = λ + h'P_j h:  GCV(λ) = p (aΔ² - 2bΔ + c) / (αΔ - β)², least at its one stationary point, at the smallest
// ridge allowed, or at infinity. A⁻¹ = A_j⁻¹ + dd'/Δ with d_j = 1 and the others -A_j⁻¹H'Wh: the column of A⁻¹ over its
// own element where j is in.
void RidgeRegression::System::choose(Eigen::Index j, const Eigen::MatrixXd& gram) {
    double& ridge = ridges[static_cast<std::size_t>(j)];
    const bool is_in = !std::isinf(ridge);
    const double share = is_in ? inverse(j, j) : 0;  // 1 / Δ as it is
    Eigen::VectorXd d;
    if (is_in) {
        d = inverse.col(j) / share;
    } else {
        d = -(inverse * gram.col(j));
        d[j] = 1;
    }
    const Eigen::VectorXd gram_d = gram * d;
    const double schur = d.dot(gram.col(j));
    const double beta = std::max(0.0, d.dot(gram_d));
    const double yph = d.dot(moments);
    const Eigen::VectorXd v = weights - (yph * share) * d;
    const Eigen::VectorXd gram_v = gram_weights - (yph * share) * gram_d;
    const double a = std::max(0.0, squares - 2 * v.dot(moments) + v.dot(gram_v));
    const double b = (yph - v.dot(gram_d)) * yph;
    const double c = beta * yph * yph;
    const double alpha = examples - (trace - beta * share);
    const auto score = [&](double delta) {
        const double rest = alpha * delta - beta;
        return (a * delta * delta - 2 * b * delta + c) / (rest * rest);
    };
    double best = kInfinity;
    double least = a / (alpha * alpha);
    const double smallest = kSmallestRidge * gram(j, j) + schur;
    const double stationary = (alpha * c - b * beta) / (b * alpha - a * beta);
    if (schur > 1e-12 * gram(j, j)) {  // or the others span it
        for (const double delta : {stationary, smallest}) {
            if (!(delta >= smallest) || !(alpha * delta > beta) || !(score(delta) < least)) continue;
            least = score(delta);
            best = delta;
        }
    }
    const double next = std::isinf(best) ? 0 : 1 / best;
    if (next == share) return;
    inverse.noalias() += ((next - share) * d) * d.transpose();
    if (std::isinf(best)) {  // exactly out, whatever was rounded
        inverse.row(j).setZero();
        inverse.col(j).setZero();
    }
    ridge = std::isinf(best) ? kInfinity : best - schur;
    weights = v + (yph * next) * d;
    gram_weights = gram_v + (yph * next) * gram_d;
    trace += beta * (next - share);
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
    system.ridges[static_cast<std::size_t>(constant_)] = kConstantRidge;
    system.inverse(constant_, constant_) = 1 / (gram_(constant_, constant_) + kConstantRidge);
    system.refresh(gram_);
    double before = system.gcv();
    for (int cycle = 0; cycle < kMostCycles; ++cycle) {
        // The linear part first, from the last function down: what it explains no Gaussian needs to.
        for (Eigen::Index j = m - 1; j >= 0; --j)
            if (j != constant_ && gram_(j, j) > 0) system.choose(j, gram_);
        system.refresh(gram_);
        const double now = system.gcv();
        if (before - now <= kSettled * before) break;
        before = now;
    }
    return finished(system);
}

RidgeFit RidgeRegression::with_ridges(std::span<const double> targets, std::span<const double> ridges) const {
    System system = begun(targets);
    const Eigen::Index m = gram_.rows();
    for (Eigen::Index j = 0; j < m; ++j) {
        const double ridge = ridges[static_cast<std::size_t>(j)];
        if (std::isinf(ridge)) continue;
        Eigen::VectorXd d = -(system.inverse * gram_.col(j));
        d[j] = 1;
        system.inverse.noalias() += (d / (ridge + d.dot(gram_.col(j)))) * d.transpose();
        system.ridges[static_cast<std::size_t>(j)] = ridge;
    }
    system.refresh(gram_);
    return finished(system);
}

RidgeFit RidgeRegression::finished(const System& system) const {
    const Eigen::VectorXd& w = system.weights;
    RidgeFit fit{{w.begin(), w.end()}, system.ridges, system.gcv(), 0};
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
