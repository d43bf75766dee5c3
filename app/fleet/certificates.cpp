// SPDX-License-Identifier: Apache-2.0
#include "fleet/certificates.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <netdb.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/owned.hpp"
#include "fleet/identity.hpp"

namespace quadrat::fleet {
namespace {

namespace fs = std::filesystem;

template <auto Function>
struct Calls {
    template <typename Object>
    void operator()(Object* object) const {
        Function(object);
    }
};
using Context = std::unique_ptr<SSL_CTX, Calls<SSL_CTX_free>>;
using Session = std::unique_ptr<SSL, Calls<SSL_free>>;
using Stream = std::unique_ptr<BIO, Calls<BIO_free_all>>;
using Certificate = std::unique_ptr<X509, Calls<X509_free>>;
using Names = std::unique_ptr<GENERAL_NAMES, Calls<GENERAL_NAMES_free>>;

constexpr timeval kPatience{4, 0};
constexpr const char* kSystemsCertificates = "/etc/ssl/certs";

// What a remote side wrote goes into a log: printable, and not long.
std::string printable(std::string_view text) {
    constexpr std::size_t kLongest = 100;
    std::string result;
    for (const char c : text.substr(0, kLongest)) result += c >= ' ' && c < '\x7f' ? c : '?';
    return result;
}

std::string text_of(const ASN1_STRING* string) {
    return printable({reinterpret_cast<const char*>(ASN1_STRING_get0_data(string)),
                      static_cast<std::size_t>(ASN1_STRING_length(string))});
}

std::string text_of(const X509_NAME* name) {
    const Stream text(BIO_new(BIO_s_mem()));
    X509_NAME_print_ex(text.get(), name, 0, XN_FLAG_ONELINE & ~ASN1_STRFLGS_ESC_MSB);
    char* bytes = nullptr;
    const long length = BIO_get_mem_data(text.get(), &bytes);
    return length > 0 ? printable({bytes, static_cast<std::size_t>(length)}) : "nobody";
}

std::string moment_text(const ASN1_TIME* time) {
    std::tm utc{};
    if (ASN1_TIME_to_tm(time, &utc) != 1) return "an unknown day";
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02} UTC", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                       utc.tm_hour, utc.tm_min);
}

std::string address_text(const ASN1_OCTET_STRING* address) {
    constexpr int kOfIpv4 = 4, kOfIpv6 = 16;
    const int length = ASN1_STRING_length(address);
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (length == kOfIpv4 || length == kOfIpv6)
        ::inet_ntop(length == kOfIpv4 ? AF_INET : AF_INET6, ASN1_STRING_get0_data(address), text.data(), text.size());
    return text.data();
}

// Whom it is for: its alternative names; where it has none, its subject.
std::string names_in(X509* certificate) {
    const Names names(
        static_cast<GENERAL_NAMES*>(X509_get_ext_d2i(certificate, NID_subject_alt_name, nullptr, nullptr)));
    std::vector<std::string> found;
    constexpr int kMost = 5;
    for (int i = 0; names && i < std::min(sk_GENERAL_NAME_num(names.get()), kMost); ++i) {
        const GENERAL_NAME* name = sk_GENERAL_NAME_value(names.get(), i);
        if (name->type == GEN_DNS) found.push_back(text_of(name->d.dNSName));
        if (name->type == GEN_IPADD) found.push_back(address_text(name->d.iPAddress));
    }
    if (found.empty()) found.push_back(text_of(X509_get_subject_name(certificate)));
    return fmt::format("{}", fmt::join(found, ", "));
}

struct Handshake {
    bool is_done = false;
    bool has_heard_tls = false;  // any word of TLS from the other side
    long verdict = X509_V_OK;
    int depth = 0;            // in the chain: 0 the broker's own
    Certificate certificate;  // the one that the verdict is about
    std::string error;        // OpenSSL's, where it is not about a certificate
};

// OpenSSL hands over a callback no argument but the session.
int index_of_handshake() {
    static const int index = SSL_get_ex_new_index(0, nullptr, nullptr, nullptr, nullptr);
    return index;
}

int note_verdict(int is_good, X509_STORE_CTX* store) {
    if (is_good == 1) return 1;
    const auto* session = static_cast<SSL*>(X509_STORE_CTX_get_ex_data(store, SSL_get_ex_data_X509_STORE_CTX_idx()));
    auto* handshake = static_cast<Handshake*>(SSL_get_ex_data(session, index_of_handshake()));
    handshake->verdict = X509_STORE_CTX_get_error(store);
    handshake->depth = X509_STORE_CTX_get_error_depth(store);
    if (X509* certificate = X509_STORE_CTX_get_current_cert(store)) {
        X509_up_ref(certificate);
        handshake->certificate.reset(certificate);
    }
    return 0;
}

void note_words(int is_written, int, int type, const void*, std::size_t, SSL*, void* handshake) {
    if (is_written == 0 && (type == SSL3_RT_HANDSHAKE || type == SSL3_RT_ALERT))
        static_cast<Handshake*>(handshake)->has_heard_tls = true;
}

base::OwnedDescriptor connected_to(const site::Broker& broker) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* list = nullptr;
    if (::getaddrinfo(broker.host.c_str(), std::to_string(broker.port).c_str(), &hints, &list) != 0) return {};
    base::OwnedDescriptor found;
    for (const addrinfo* one = list; one != nullptr && !found; one = one->ai_next) {
        base::OwnedDescriptor socket(::socket(one->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
        ::setsockopt(socket.get(), SOL_SOCKET, SO_SNDTIMEO, &kPatience, sizeof kPatience);
        ::setsockopt(socket.get(), SOL_SOCKET, SO_RCVTIMEO, &kPatience, sizeof kPatience);
        if (::connect(socket.get(), one->ai_addr, one->ai_addrlen) == 0) found = std::move(socket);
    }
    ::freeaddrinfo(list);
    return found;
}

bool expects(SSL* session, const std::string& host) {
    X509_VERIFY_PARAM* parameters = SSL_get0_param(session);
    if (X509_VERIFY_PARAM_set1_ip_asc(parameters, host.c_str()) == 1) return true;
    return SSL_set_tlsext_host_name(session, host.c_str()) == 1 && SSL_set1_host(session, host.c_str()) == 1;
}

void shake_hands(SSL_CTX* context, const base::OwnedDescriptor& socket, const site::Broker& broker,
                 Handshake& handshake) {
    const Session session(SSL_new(context));
    if (!session || !expects(session.get(), broker.host)) return;
    SSL_set_ex_data(session.get(), index_of_handshake(), &handshake);
    SSL_set_verify(session.get(), SSL_VERIFY_PEER, note_verdict);
    SSL_set_msg_callback(session.get(), note_words);
    SSL_set_msg_callback_arg(session.get(), &handshake);
    SSL_set_fd(session.get(), socket.get());
    ERR_clear_error();
    handshake.is_done = SSL_connect(session.get()) == 1;
    const char* reason = ERR_reason_error_string(ERR_peek_last_error());
    handshake.error = reason != nullptr ? reason : "it was broken off";
    ERR_clear_error();
}

bool is_about_the_issuer(long verdict) {
    switch (verdict) {
        case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT:
        case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT_LOCALLY:
        case X509_V_ERR_UNABLE_TO_VERIFY_LEAF_SIGNATURE:
        case X509_V_ERR_SELF_SIGNED_CERT_IN_CHAIN:
        case X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT:
        case X509_V_ERR_CERT_SIGNATURE_FAILURE:
        case X509_V_ERR_CERT_UNTRUSTED:
        case X509_V_ERR_INVALID_CA:
            return true;
        default:
            return false;
    }
}

std::string trouble_of(const Handshake& handshake, const site::Broker& broker, const fs::path& ca_file) {
    X509* certificate = handshake.certificate.get();
    const std::string whose =
        handshake.depth == 0 ? "the broker's certificate" : "a certificate that vouches for the broker's";
    if (certificate == nullptr) return X509_verify_cert_error_string(handshake.verdict);
    if (handshake.verdict == X509_V_ERR_HOSTNAME_MISMATCH || handshake.verdict == X509_V_ERR_IP_ADDRESS_MISMATCH)
        return fmt::format(
            "{} is of another host: it has the name {}, not {}; write that name in fleet.broker, or give the broker a "
            "certificate with this one",
            whose, names_in(certificate), broker.host);
    if (handshake.verdict == X509_V_ERR_CERT_HAS_EXPIRED)
        return fmt::format("{} has expired, on {}; renew it at the broker, if this machine's clock is right", whose,
                           moment_text(X509_get0_notAfter(certificate)));
    if (handshake.verdict == X509_V_ERR_CERT_NOT_YET_VALID)
        return fmt::format("{} is valid from {} on only; is this machine's clock right? quadrat doctor --only clock",
                           whose, moment_text(X509_get0_notBefore(certificate)));
    if (is_about_the_issuer(handshake.verdict))
        return fmt::format(
            "the broker's certificate is not signed by anybody in {}: {} signed it; name the file with the certificate "
            "of that authority in fleet.ca_file",
            ca_file.empty() ? kSystemsCertificates : ca_file.string(), text_of(X509_get_issuer_name(certificate)));
    return fmt::format("{}: {}", whose, X509_verify_cert_error_string(handshake.verdict));
}

}  // namespace

void require_certificates(const fs::path& ca_file) {
    constexpr std::size_t kLargest = 4U << 20U;
    const std::string bytes = read_named("fleet.ca_file", ca_file, kLargest);
    const auto refuse = [&](const char* what) {
        throw base::InputError(fmt::format("fleet.ca_file: {} {}", ca_file.string(), what));
    };
    const Stream text(BIO_new_mem_buf(bytes.data(), static_cast<int>(bytes.size())));
    const Certificate first(PEM_read_bio_X509(text.get(), nullptr, nullptr, nullptr));
    ERR_clear_error();
    if (first) return;
    const auto* at = reinterpret_cast<const unsigned char*>(bytes.data());
    const Certificate binary(d2i_X509(nullptr, &at, static_cast<long>(bytes.size())));
    ERR_clear_error();
    if (binary) refuse("is a certificate in DER form; write it as PEM: openssl x509 -inform der -in THIS -out ca.pem");
    if (bytes.find("PRIVATE KEY-----") != std::string::npos)
        refuse("holds a private key and no certificate; name the file that begins with -----BEGIN CERTIFICATE-----");
    refuse("holds no certificate; name a file that begins with -----BEGIN CERTIFICATE-----");
}

std::string tls_trouble(const site::Broker& broker, const fs::path& ca_file) {
    const Context context(SSL_CTX_new(TLS_client_method()));
    if (!context) return {};
    const int is_loaded = ca_file.empty() ? SSL_CTX_load_verify_dir(context.get(), kSystemsCertificates)
                                          : SSL_CTX_load_verify_file(context.get(), ca_file.c_str());
    if (is_loaded != 1) return fmt::format("{} cannot be used any more", ca_file.string());
    const base::OwnedDescriptor socket = connected_to(broker);
    if (!socket) return {};
    Handshake handshake;
    shake_hands(context.get(), socket, broker, handshake);
    if (handshake.is_done) return {};
    if (handshake.verdict != X509_V_OK) return trouble_of(handshake, broker, ca_file);
    if (!handshake.has_heard_tls)
        return "the broker speaks no TLS on this port; write the port on which it does (8883, mostly), or mqtt:// to "
               "do without encryption";
    return fmt::format("the broker and this machine agree on no encryption: {}", handshake.error);
}

}  // namespace quadrat::fleet
