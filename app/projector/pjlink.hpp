// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "projector/projector.hpp"

namespace quadrat::projector {

// What a projector says first, without its carriage return. The random number is eight hexadecimal digits where it
// wants a password, "" where it wants none. Takes any bytes. Throws Trouble.
std::string challenge_of(std::string_view greeting);

// "%1POWR ?" with what proves the password, which may be ""; as it is sent.
std::string command_text(const std::string& challenge, const std::string& password, std::string_view command);

// What follows the equals sign in the answer to "POWR", say; nothing where the projector cannot now. Takes any bytes.
// Throws Trouble.
std::optional<std::string> answer_from(std::string_view line, std::string_view command);

// Throws Trouble.
Power power_from(std::string_view answer);
// Of the six digits that ERST answers: fan, lamp, temperature, cover, filter, other. Whatever else: "".
std::string ailments_from(std::string_view answer);

std::unique_ptr<Projector> open_pjlink(const PjLink& to, const std::string& password,
                                       std::chrono::milliseconds patience);

}  // namespace quadrat::projector
