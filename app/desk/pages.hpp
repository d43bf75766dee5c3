// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "desk/desk.hpp"

// The desk's pages: plain HTML that works without its script, on a phone, by keyboard and read aloud. What is marked
// data-live is brought up to date by the script.
namespace quadrat::desk {

// What every page is told.
struct View {
    const Sources& sources;
    const Texts& say;
    std::string path;        // of this page
    std::string form_token;  // "" without a session: there is nothing to press then
    std::string done;        // what has just been done, in words; or ""
};

std::string login_page(const View& view, const std::string& trouble);
// `health`: as the exhibit says it, or nothing where none runs.
std::string exhibit_page(const View& view, const std::optional<std::string>& health);
std::string faults_page(const View& view, const std::vector<Fault>& faults);
std::string log_page(const View& view, const std::vector<std::string>& lines, const std::vector<std::string>& notes);
std::string doctor_page(const View& view, const std::vector<Finding>& findings);
// `preview`: of a backup that was brought, or null.
std::string backup_page(const View& view, const Preview* preview);
// `why` is a key of the texts; `words` come from the program itself, in English.
std::string trouble_page(const View& view, const std::string& why, const std::string& words);

inline constexpr int kMostUpload_MB = 64;

}  // namespace quadrat::desk
