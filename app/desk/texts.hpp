// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace quadrat::desk {

// What the pages say in one language, by key. Data: desk/languages/*.json, inside the binary.
class Texts {
  public:
    // Throws InputError naming the source and what is wrong with it.
    static Texts from_json(std::string_view json, std::string code, std::string_view source);

    const std::string& code() const { return code_; }            // "de", as of BCP 47
    const std::string& name() const { return name_; }            // in itself: "Deutsch"
    const std::string& direction() const { return direction_; }  // "ltr" or "rtl"
    const std::map<std::string, std::string, std::less<>>& all() const { return texts_; }

    // In English where this language has none for the key; "" where English has none either.
    const std::string& operator()(std::string_view key) const;
    // With each "{}" replaced by one of these, in their order.
    std::string operator()(std::string_view key, std::initializer_list<std::string> holes) const;

  private:
    std::string code_, name_, direction_;
    std::map<std::string, std::string, std::less<>> texts_;
};

const std::vector<Texts>& languages();  // by their codes, sorted

// The language of a code ("de", "fr-CA"); null for one that is not spoken.
const Texts* language_of(std::string_view code);

// What a browser's Accept-Language wants most of what is spoken, by its weights (RFC 9110, 12.5.4); English where it
// wants nothing of it. Takes any text.
const Texts& preferred_language(std::string_view accepted);

}  // namespace quadrat::desk
