// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

namespace quadrat::desk {

inline constexpr std::size_t kShortestPassphrase = 10;  // bytes
inline constexpr std::size_t kLongestPassphrase = 256;
inline constexpr std::size_t kSaltBytes = 16;

// What is kept of a passphrase: "scrypt$15$SALT$KEY", in hexadecimal (scrypt, Percival 2009, by OpenSSL, with r = 8 and
// p = 1). It takes about a tenth of a second and 32 MB, so that guessing is slow. Throws InputError where the
// passphrase is too short or too long.
std::string hash_of(std::string_view passphrase, std::string_view salt);

// Whether it is that one; false for a hash that cannot be read. The time it takes does not tell how much was right.
bool is_passphrase(std::string_view passphrase, std::string_view hash);

// Two texts, in a time that does not tell where they differ.
bool are_same_secrets(std::string_view a, std::string_view b);

std::string hexadecimal(std::string_view bytes);

}  // namespace quadrat::desk
