// SPDX-License-Identifier: Apache-2.0
// Weights and GCV against their definitions, solved another way: dense matrices and Gauss elimination, no updates.
#include "breeding/words/ridge.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "base/seed.hpp"

namespace quadrat::breeding {
namespace {

struct Problem {
    Eigen::MatrixXd design;
    std::vector<double> weights;
    std::vector<double> targets;
};

Problem problem(int rows, int columns, std::uint64_t seed) {
    base::RandomStream chance{base::Seed{seed}};
    Problem p{Eigen::MatrixXd(rows, columns), {}, {}};
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) p.design(i, j) = chance.unit();
        p.design(i, 0) = 1;
        p.weights.push_back(0.5 + chance.unit());
        p.targets.push_back(0.3 * p.design(i, 1) - 0.5 * p.design(i, 2) + 0.1 * chance.unit());
    }
    return p;
}

struct ByDefinition {
    Eigen::VectorXd weights;
    double gcv;
    double leave_one_out;
};

// Dropped functions leave the design; the rest is (H'WH + Λ)⁻¹H'Wy and p|Py|²/tr(P)² as written.
ByDefinition by_definition(const Problem& p, const std::vector<double>& ridges) {
    std::vector<Eigen::Index> kept;
    for (std::size_t j = 0; j < ridges.size(); ++j)
        if (std::isfinite(ridges[j])) kept.push_back(static_cast<Eigen::Index>(j));
    const auto n = static_cast<Eigen::Index>(kept.size());
    Eigen::MatrixXd h(p.design.rows(), n);
    Eigen::MatrixXd ridge = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd y(p.design.rows());
    for (Eigen::Index i = 0; i < h.rows(); ++i) {
        const double root = std::sqrt(p.weights[static_cast<std::size_t>(i)]);
        y[i] = root * p.targets[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < n; ++j) h(i, j) = root * p.design(i, kept[static_cast<std::size_t>(j)]);
    }
    for (Eigen::Index j = 0; j < n; ++j)
        ridge(j, j) = ridges[static_cast<std::size_t>(kept[static_cast<std::size_t>(j)])];
    const Eigen::MatrixXd inverse = (h.transpose() * h + ridge).fullPivLu().inverse();
    const Eigen::VectorXd w = inverse * h.transpose() * y;
    const Eigen::MatrixXd projection = Eigen::MatrixXd::Identity(h.rows(), h.rows()) - h * inverse * h.transpose();
    ByDefinition found{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(ridges.size())), 0, 0};
    for (Eigen::Index j = 0; j < n; ++j) found.weights[kept[static_cast<std::size_t>(j)]] = w[j];
    const auto rows = static_cast<double>(h.rows());
    found.gcv = rows * (projection * y).squaredNorm() / (projection.trace() * projection.trace());
    double errors = 0;
    double total = 0;
    for (Eigen::Index i = 0; i < h.rows(); ++i) {  // each example really left out
        Eigen::MatrixXd rest = h;
        Eigen::VectorXd rest_y = y;
        rest.row(i).setZero();
        rest_y[i] = 0;
        const Eigen::VectorXd told = (rest.transpose() * rest + ridge).fullPivLu().solve(rest.transpose() * rest_y);
        errors += std::pow(y[i] - h.row(i) * told, 2);
        total += p.weights[static_cast<std::size_t>(i)];
    }
    found.leave_one_out = std::sqrt(errors / total);
    return found;
}

class Ridge : public testing::TestWithParam<int> {};

TEST_P(Ridge, WeightsGcvAndLeaveOneOutEqualTheirDefinitions) {
    const Problem p = problem(14 + GetParam(), 5 + GetParam() % 3, static_cast<std::uint64_t>(GetParam()));
    const RidgeFit fit = RidgeRegression(p.design, p.weights, 0).fit(p.targets);
    const ByDefinition expected = by_definition(p, fit.ridges);
    for (std::size_t j = 0; j < fit.weights.size(); ++j)
        EXPECT_NEAR(fit.weights[j], expected.weights[static_cast<Eigen::Index>(j)], 1e-7) << j;
    EXPECT_NEAR(fit.gcv / expected.gcv, 1, 1e-6);
    EXPECT_NEAR(fit.leave_one_out, expected.leave_one_out, 1e-7);
}

TEST_P(Ridge, NoOtherRidgeOfOneFunctionHasALesserGcv) {
    const Problem p = problem(14 + GetParam(), 5 + GetParam() % 3, static_cast<std::uint64_t>(GetParam()));
    const RidgeRegression regression(p.design, p.weights, 0);
    const RidgeFit fit = regression.fit(p.targets);
    const Eigen::MatrixXd gram =
        p.design.transpose() * Eigen::VectorXd::Map(p.weights.data(), p.design.rows()).asDiagonal() * p.design;
    for (std::size_t j = 1; j < fit.ridges.size(); ++j)
        for (double ridge = 0.02 * gram(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(j)); ridge < 1e6;
             ridge *= 1.7) {
            std::vector<double> other = fit.ridges;
            other[j] = ridge;
            EXPECT_GE(by_definition(p, other).gcv, fit.gcv * (1 - 2e-3)) << j << " " << ridge;
        }
}

INSTANTIATE_TEST_SUITE_P(Problems, Ridge, testing::Range(0, 6));

TEST(Ridge, DropsWhatTellsNothing) {
    Problem p = problem(40, 4, 9);
    for (int i = 0; i < 40; ++i) p.targets[static_cast<std::size_t>(i)] = 0.7 * p.design(i, 1);
    const RidgeFit fit = RidgeRegression(p.design, p.weights, 0).fit(p.targets);
    EXPECT_TRUE(std::isfinite(fit.ridges[1]));
    EXPECT_GT(fit.weights[1], 0.6);
}

TEST(Ridge, StandsASingularSystem) {
    Problem p = problem(6, 5, 3);
    p.design.col(3) = p.design.col(2);  // twice the same function
    p.design.col(4).setZero();          // one that is nowhere
    p.targets.assign(6, 0.4);           // nothing to tell
    const RidgeFit fit = RidgeRegression(p.design, p.weights, 0).fit(p.targets);
    for (const double w : fit.weights) EXPECT_TRUE(std::isfinite(w));
    EXPECT_NEAR(fit.weights[0], 0.4, 1e-6);
}

}  // namespace
}  // namespace quadrat::breeding
