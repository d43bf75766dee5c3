// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "site/mistake.hpp"
#include "site/parse_toml.hpp"

namespace quadrat::site {

// One reader for a whole file of settings: it hands out values, remembers which keys were asked for, and notes what is
// wrong. A key that is wrong or not there leaves its value as it is.
class ConfigurationReader {
  public:
    // Throws std::exception with "what is wrong; what would be right" for a text that cannot be used.
    using Check = std::function<void(const std::string& text)>;
    using Names = std::vector<std::string>;

    // Both are borrowed. A value that was read from another source is told by that.
    ConfigurationReader(const toml::table& root, const std::string& source) : root_(root), source_(source) {}

    void read(const char* table, const char* key, double& value, double low, double high);
    void read(const char* table, const char* key, int& value, int low, int high);
    void read_one_of(const char* table, const char* key, int& value, const std::vector<int>& allowed);
    void read(const char* table, const char* key, bool& value);
    void read(const char* table, const char* key, std::string& value, const Names& allowed = {});
    void read(const char* table, const char* key, std::vector<std::string>& values, const Names& allowed = {});
    void read_checked(const char* table, const char* key, std::string& value, const Check& check);
    void read_checked(const char* table, const char* key, std::vector<std::string>& values, const Check& check);

    // For values of other forms. Null: it is not there.
    const toml::node* find(const char* table, const char* key);
    const toml::table* find_table(const char* table);
    // This key is no mistake of its own, nor one that others are told of.
    void pass_over(const std::string& table, const std::string& key) { passed_over_.insert(table + "." + key); }
    // False: noted as wrong.
    bool read_text(const toml::node& node, const std::string& name, std::string& text, const Check& check);
    void refuse(const toml::node& node, const std::string& name, const std::string& what, const std::string& remedy);

    // Call last: whatever nobody asked for is a mistake.
    void refuse_what_was_not_read();

    const std::vector<Mistake>& mistakes() const { return mistakes_; }

  private:
    void refuse_unknown(const toml::node& node, const std::string& name, const Names& known);
    const std::string& source_of(const toml::node& node) const;
    Names tables() const;

    const toml::table& root_;
    const std::string& source_;
    std::map<std::string, Names> known_;
    std::set<std::string> passed_over_;
    std::vector<Mistake> mistakes_;
};

}  // namespace quadrat::site
