// SPDX-License-Identifier: Apache-2.0
#include "genome/language_po.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text_file.hpp"
#include "genome/json_text.hpp"
#include "genome/speech.hpp"

namespace quadrat::genome {
namespace {

using nlohmann::json;

struct Text {
    std::string key, text;
};

// Depth first, in the order of the file's keys.
void flatten(const json& value, const std::string& key, std::vector<Text>& texts) {
    if (value.is_string()) {
        texts.push_back({key, value.get<std::string>()});
        return;
    }
    const auto under = [&](const std::string& name) { return key.empty() ? name : key + "/" + name; };
    if (value.is_object())
        for (const auto& [name, inner] : value.items()) flatten(inner, under(name), texts);
    if (value.is_array())
        for (std::size_t i = 0; i < value.size(); ++i) flatten(value[i], under(std::to_string(i)), texts);
}

std::vector<Text> texts_of(std::string_view code) {
    std::vector<Text> texts;
    const std::string_view own = language_json(code);
    if (!own.empty()) flatten(parse_json(own, code), "", texts);
    return texts;
}

std::string in_quotes(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (c == '\n')
            out += "\\n";
        else if (c == '\t')
            out += "\\t";
        else
            out += c;
    }
    return out + '"';
}

class Reader {
  public:
    Reader(std::string_view po, std::string_view source) : left_(po), source_(source) {}

    // Context and translation of each entry; the header has none.
    std::vector<std::pair<Text, int>> entries() {
        std::vector<std::pair<Text, int>> all;
        std::optional<std::string> context;
        std::string* filled = nullptr;
        std::string id, text;
        bool has_text = false;
        const auto end_entry = [&] {
            if (has_text && context) all.emplace_back(Text{*context, text}, began_);
            context.reset();
            id.clear();
            text.clear();
            has_text = false;
            filled = nullptr;
        };
        while (next_line()) {
            if (line_.empty()) {
                end_entry();
            } else if (line_.front() == '#') {
                if (has_text) end_entry();
            } else if (take("msgctxt")) {
                if (has_text) end_entry();
                began_ = number_;
                filled = &context.emplace();
            } else if (line_.starts_with("msgid_plural") || line_.starts_with("msgstr[")) {
                refuse("no text of ours has plural forms");
            } else if (take("msgid")) {
                if (has_text) end_entry();
                filled = &id;
            } else if (take("msgstr")) {
                has_text = true;
                filled = &text;
            } else if (line_.front() != '"' || filled == nullptr) {
                refuse("is no line of a PO file: msgctxt, msgid, msgstr or a text between quotation marks");
            }
            if (filled != nullptr && !line_.empty() && line_.front() != '#') *filled += unquoted();
        }
        end_entry();
        return all;
    }

    [[noreturn]] void refuse(const std::string& what, int line = 0) const {
        throw base::InputError(fmt::format("{}:{}: {}", source_, line > 0 ? line : number_, what));
    }

  private:
    static std::string_view trimmed(std::string_view text) {
        const std::size_t from = text.find_first_not_of(" \t\r");
        if (from == std::string_view::npos) return {};
        return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
    }

    bool next_line() {
        if (left_.empty()) return false;
        ++number_;
        const std::size_t end = left_.find('\n');
        line_ = trimmed(left_.substr(0, end));
        left_.remove_prefix(end == std::string_view::npos ? left_.size() : end + 1);
        return true;
    }

    bool take(std::string_view word) {
        if (!line_.starts_with(word)) return false;
        const std::string_view rest = line_.substr(word.size());
        if (rest.empty() || (rest.front() != ' ' && rest.front() != '\t' && rest.front() != '"')) return false;
        line_ = trimmed(rest);
        return true;
    }

    std::string unquoted() const {
        if (line_.size() < 2 || line_.front() != '"' || line_.back() != '"')
            refuse("a text begins and ends with a quotation mark");
        std::string text;
        const std::string_view inner = line_.substr(1, line_.size() - 2);
        for (std::size_t i = 0; i < inner.size(); ++i) {
            if (inner[i] == '"') refuse("a quotation mark in a text is written \\\"");
            if (inner[i] != '\\') {
                text += inner[i];
                continue;
            }
            if (++i == inner.size()) refuse("a text ends within \\");
            switch (inner[i]) {
                case 'n':
                    text += '\n';
                    break;
                case 't':
                    text += '\t';
                    break;
                case '"':
                case '\\':
                    text += inner[i];
                    break;
                default:
                    refuse(fmt::format("there is no \\{}", std::string(1, inner[i])));
            }
        }
        return text;
    }

    std::string_view left_, source_, line_;
    int number_ = 0;
    int began_ = 0;
};

// Lays a text under its key, as far as English has the same: objects by name, pairs by place.
void put(json& root, const json& english, std::string_view key, const std::string& text) {
    json* at = &root;
    const json* like = &english;
    while (!key.empty()) {
        const std::size_t end = key.find('/');
        const std::string name(key.substr(0, end));
        key.remove_prefix(end == std::string_view::npos ? key.size() : end + 1);
        if (like->is_array()) {
            const auto place = static_cast<std::size_t>(std::stoul(name));
            if (at->is_null()) *at = json::array({"", ""});
            at = &(*at)[place];
            like = &(*like)[place];
        } else {
            at = &(*at)[name];
            like = &(*like)[name];
        }
    }
    *at = text;
}

// A pair of which one end is missing is none.
void drop_halves(json& value) {
    if (!value.is_object()) return;
    std::vector<std::string> halves;
    for (auto& [name, inner] : value.items()) {
        drop_halves(inner);
        if (inner.is_array() && (inner[0] == "" || inner[1] == "")) halves.push_back(name);
    }
    for (const std::string& name : halves) value.erase(name);
}

}  // namespace

std::string po_of(std::string_view code) {
    std::map<std::string, std::string> own;
    for (Text& text : texts_of(code)) own[text.key] = std::move(text.text);
    std::string po = fmt::format(
        "# Quadrat: what the exhibit says.\n"
        "# {{}} and names in braces are places that other texts come to; they stay. Word ends (words/…/0 and 1) are "
        "adjectives\n# that agree with the noun of trees/with, land/with or sky/with.\n"
        "msgid \"\"\nmsgstr \"\"\n\"Language: {}\\n\"\n\"MIME-Version: 1.0\\n\"\n"
        "\"Content-Type: text/plain; charset=UTF-8\\n\"\n\"Content-Transfer-Encoding: 8bit\\n\"\n",
        code);
    for (const Text& english : texts_of("en")) {
        const auto found = own.find(english.key);
        po += fmt::format("\nmsgctxt {}\nmsgid {}\nmsgstr {}\n", in_quotes(english.key), in_quotes(english.text),
                          in_quotes(found == own.end() ? "" : found->second));
    }
    return po;
}

std::string json_of_po(std::string_view po, std::string_view source) {
    std::map<std::string, int> known;
    for (const Text& text : texts_of("en")) known[text.key] = 0;
    const json english = parse_json(language_json("en"), "en");
    json root = json::object();
    const std::string text_of_po = base::text_from(std::string(po), source, base::kJsonLimits);
    Reader reader(text_of_po, source);
    for (const auto& [text, line] : reader.entries()) {
        const auto found = known.find(text.key);
        if (found == known.end()) reader.refuse(fmt::format("there is no text {}", brief(json(text.key))), line);
        if (std::exchange(found->second, line) > 0)
            reader.refuse(fmt::format("{} comes a second time", brief(json(text.key))), line);
        if (!text.text.empty()) put(root, english, text.key, text.text);
    }
    drop_halves(root);
    return root.dump(2) + "\n";
}

}  // namespace quadrat::genome
