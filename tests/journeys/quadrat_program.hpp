// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/process.hpp"

namespace quadrat::tests {

inline std::vector<std::string> program(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), QUADRAT_BINARY);
    return arguments;
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t start = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', start)) {
        lines.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    if (start < text.size()) lines.push_back(text.substr(start));
    return lines;
}

inline std::size_t count_of(const std::string& text, const std::string& what) {
    std::size_t count = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
    return count;
}

// With what it said, where it did not.
inline testing::AssertionResult ends_with(const Ended& ended, int status) {
    if (ended.status == status || ended.is_lost_to_leak_sanitizer()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "ended with " << ended.status << ": " << ended.err;
}

inline testing::AssertionResult succeeds(const Ended& ended) { return ends_with(ended, 0); }

}  // namespace quadrat::tests
