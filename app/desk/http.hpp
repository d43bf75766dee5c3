// SPDX-License-Identifier: Apache-2.0
// The room `desk`: a page for those who look after the exhibit. It speaks HTTP, knows who has logged in, and says what
// they see. What it tells and does is handed in: nothing here knows the exhibit.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrat::desk {

using Fields = std::map<std::string, std::string>;

struct Request {
    std::string method;                  // "GET"
    std::string path;                    // "/doctor", without a query
    Fields headers;                      // by names in small letters
    Fields form;                         // of a POST; of a GET its query
    std::string peer;                    // the address it came from
    std::filesystem::path brought = {};  // a file that came with a form, gone when it was answered; "" for none
    // Why what came cannot be used, with the status that says so; 0 where it can.
    int refusal = 0;
    std::string trouble = {};
};

struct Answer {
    int status = 200;
    std::string type = "text/html; charset=utf-8";
    std::string body;
    std::vector<std::pair<std::string, std::string>> headers;
};

// "a=1&b=%C3%A4+x" as application/x-www-form-urlencoded has it. Of a name that comes twice the first counts; what is
// not well-formed, or holds a zero byte, makes it nothing at all.
std::optional<Fields> fields_of(std::string_view form);

// The value of a cookie in a Cookie header; "" where it is not there.
std::string cookie_of(std::string_view header, std::string_view name);

}  // namespace quadrat::desk
