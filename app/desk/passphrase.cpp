// SPDX-License-Identifier: Apache-2.0
#include "desk/passphrase.hpp"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/evp.h>

#include <array>
#include <optional>

#include "base/error.hpp"

namespace quadrat::desk {
namespace {

constexpr int kLogRounds = 15;
constexpr std::size_t kKeyBytes = 32;
constexpr std::string_view kBegin = "scrypt$15$";

std::optional<std::string> key_of(std::string_view passphrase, std::string_view salt) {
    std::string key(kKeyBytes, '\0');
    constexpr std::uint64_t kMostBytes = std::uint64_t{64} << 20U;
    if (EVP_PBE_scrypt(passphrase.data(), passphrase.size(), reinterpret_cast<const unsigned char*>(salt.data()),
                       salt.size(), std::uint64_t{1} << kLogRounds, 8, 1, kMostBytes,
                       reinterpret_cast<unsigned char*>(key.data()), key.size()) != 1)
        return std::nullopt;
    return key;
}

std::optional<std::string> bytes_of(std::string_view hex) {
    if (hex.size() % 2 != 0) return std::nullopt;
    std::string bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2) {
        int value = 0;
        for (const char c : hex.substr(i, 2)) {
            const std::size_t digit = std::string_view("0123456789abcdef").find(c);
            if (digit == std::string_view::npos) return std::nullopt;
            value = 16 * value + static_cast<int>(digit);
        }
        bytes += static_cast<char>(value);
    }
    return bytes;
}

}  // namespace

std::string hexadecimal(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) text += fmt::format("{:02x}", static_cast<unsigned char>(c));
    return text;
}

std::string hash_of(std::string_view passphrase, std::string_view salt) {
    if (passphrase.size() < kShortestPassphrase)
        throw base::InputError(
            fmt::format("a passphrase has at least {} characters: a sentence is easy to keep", kShortestPassphrase));
    if (passphrase.size() > kLongestPassphrase)
        throw base::InputError(fmt::format("a passphrase has at most {} bytes", kLongestPassphrase));
    const auto key = key_of(passphrase, salt);
    if (!key) throw base::InputError("the passphrase could not be hashed: OpenSSL has no memory for it");
    return std::string(kBegin) + hexadecimal(salt) + "$" + hexadecimal(*key);
}

bool is_passphrase(std::string_view passphrase, std::string_view hash) {
    if (!hash.starts_with(kBegin) || passphrase.size() > kLongestPassphrase) return false;
    hash.remove_prefix(kBegin.size());
    const std::size_t dollar = hash.find('$');
    if (dollar == std::string_view::npos) return false;
    const auto salt = bytes_of(hash.substr(0, dollar));
    const auto right = bytes_of(hash.substr(dollar + 1));
    if (!salt || !right || right->size() != kKeyBytes) return false;
    const auto key = key_of(passphrase, *salt);
    return key && are_same_secrets(*key, *right);
}

bool are_same_secrets(std::string_view a, std::string_view b) {
    return a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace quadrat::desk
