// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quadrat::base {

// Transcendental functions of additions, products, quotients and square roots alone, which IEEE 754 rounds the same on
// every processor: the same bits everywhere, unlike a C library's. Relative error under 1e-14 where not said.

double portable_exp(double x);  // 0 below -708, infinity above 709
double portable_log(double x);  // x > 0; minus infinity for 0

double normal_density(double x);
double normal_cumulative(double x);  // absolute error under 1e-14; 0 far to the left, 1 far to the right

}  // namespace quadrat::base
