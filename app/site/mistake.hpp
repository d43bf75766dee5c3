// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace quadrat::site {

// One thing that is wrong with a file of settings.
struct Mistake {
    std::string file;
    int line = 0;        // 0: the file as a whole
    std::string what;    // "visit.rounds is 900"
    std::string remedy;  // "it must lie between 1 and 50"; may be empty
    friend bool operator==(const Mistake&, const Mistake&) = default;
};

// "site.toml:2: visit.rounds is 900; it must lie between 1 and 50"
std::string to_text(const Mistake& mistake);

// The same without control characters, which would break a line of the log or colour a terminal: \n stands for a new
// line.
Mistake on_one_line(Mistake mistake);

// A message of the form "what is wrong; what would be right", taken apart at its last semicolon.
Mistake mistake_from(const std::string& file, int line, std::string_view message);

// Settings that cannot be used. what() has a line for each mistake.
class SettingsError : public base::InputError {
  public:
    explicit SettingsError(std::vector<Mistake> mistakes);
    const std::vector<Mistake>& mistakes() const { return mistakes_; }

  private:
    std::vector<Mistake> mistakes_;
};

}  // namespace quadrat::site
