// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>
#include <string>

namespace quadrat::base {

// Bad input from outside, or hardware missing at start: one line naming the file, the place, what is wrong and what
// would be right. Caught once, in main, which prints it and exits with 2. Trouble while running is a value instead.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace quadrat::base
