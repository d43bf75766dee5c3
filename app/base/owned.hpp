// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <utility>

namespace quadrat::base {

// A handle that is closed exactly once: move-only, with a named deleter and a value that means "nothing". A deleter
// that counts has static taken() and left(), called for each handle that comes to be owned and that goes.
//     struct CloseDescriptor { void operator()(int fd) const; };
//     using OwnedDescriptor = Owned<int, CloseDescriptor, -1>;
template <typename Handle, typename Deleter, Handle Nothing = Handle{}>
class Owned {
  public:
    Owned() = default;
    explicit Owned(Handle handle) : handle_(handle) { tell_taken(); }
    Owned(Owned&& other) noexcept : handle_(std::exchange(other.handle_, Nothing)) {}
    Owned& operator=(Owned&& other) noexcept {
        if (this != &other) {
            reset();
            handle_ = std::exchange(other.handle_, Nothing);
        }
        return *this;
    }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;
    ~Owned() { reset(); }

    Handle get() const { return handle_; }
    explicit operator bool() const { return handle_ != Nothing; }
    Handle release() {
        tell_left();
        return std::exchange(handle_, Nothing);
    }
    void reset(Handle handle = Nothing) {
        if (handle_ != Nothing) Deleter{}(handle_);
        tell_left();
        handle_ = handle;
        tell_taken();
    }

  private:
    void tell_taken() const {
        if constexpr (requires { Deleter::taken(); })
            if (handle_ != Nothing) Deleter::taken();
    }
    void tell_left() const {
        if constexpr (requires { Deleter::left(); })
            if (handle_ != Nothing) Deleter::left();
    }

    Handle handle_ = Nothing;
};

struct CloseDescriptor {
    void operator()(int fd) const noexcept;
};
using OwnedDescriptor = Owned<int, CloseDescriptor, -1>;

}  // namespace quadrat::base
