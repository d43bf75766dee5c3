// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "base/listen_address.hpp"
#include "desk/http.hpp"

struct MHD_Daemon;

namespace quadrat::desk {

struct ServerOptions {
    base::ListenAddress address;
    std::string certificate, key;  // PEM; both "" for none: nothing is encrypted
};

// An HTTP server (libmicrohttpd) on one thread of its own: requests are answered one after the other. What a request
// may cost is bounded: 16 connections an address and 64 in all, 6 s without a byte, 4 kB of a form, 32 kB of headers.
class Server {
  public:
    // `respond` is called on the server's thread and must not throw. Throws InputError: the address is taken or not
    // this machine's, or the certificate and its key are no pair.
    Server(const ServerOptions& options, std::function<Answer(const Request&)> respond);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

  private:
    struct Stop {
        void operator()(MHD_Daemon* daemon) const;
    };
    std::function<Answer(const Request&)> respond_;
    std::unique_ptr<MHD_Daemon, Stop> daemon_;
};

}  // namespace quadrat::desk
