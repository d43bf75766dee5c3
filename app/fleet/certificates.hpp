// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

#include "site/broker_address.hpp"

namespace quadrat::fleet {

// Throws InputError where no certificate can be read from this file: it is missing, of another form, or holds a key.
void require_certificates(const std::filesystem::path& ca_file);

// Why this broker cannot be trusted, and what mends it: shakes hands with it as a client would, says nothing else, and
// goes. libmosquitto says "a TLS error" of a certificate of another host, of one that has expired, of one that somebody
// else vouches for, and of a broker that speaks no TLS. "" where nothing is wrong, or it cannot be reached. Waits for
// some seconds at most. Without a `ca_file`, those that the system trusts vouch.
std::string tls_trouble(const site::Broker& broker, const std::filesystem::path& ca_file);

}  // namespace quadrat::fleet
