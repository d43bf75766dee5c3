// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "desk/desk.hpp"

// The desk's pages: plain HTML that works without its script, on a phone, by keyboard and read aloud.
namespace quadrat::desk {

std::string login_page(const Sources& sources, const std::string& trouble);
// `health`: as the exhibit says it, or nothing where none runs.
std::string exhibit_page(const Sources& sources, const std::optional<std::string>& health,
                         const std::string& form_token, const std::string& done);
std::string doctor_page(const Sources& sources, const std::vector<Finding>& findings);
std::string trouble_page(const Sources& sources, int status, const std::string& trouble);

extern const char* const kStyle;
extern const char* const kScript;

}  // namespace quadrat::desk
