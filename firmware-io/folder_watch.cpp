// SPDX-License-Identifier: Apache-2.0
#include "firmware-io/folder_watch.hpp"

#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string_view>

namespace quadrat::firmware_io {

FolderWatch::FolderWatch(const std::filesystem::path& folder, std::string prefix)
    : prefix_{std::move(prefix)}, descriptor_{::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)} {
    if (descriptor_ < 0) return;
    // udev gives a new node to its group some time after the kernel made it: that is an attribute.
    constexpr std::uint32_t kComingAndGoing = IN_CREATE | IN_DELETE | IN_ATTRIB | IN_MOVED_FROM | IN_MOVED_TO;
    ::inotify_add_watch(descriptor_, folder.c_str(), kComingAndGoing);
}

FolderWatch::~FolderWatch() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

bool FolderWatch::take_news() {
    if (descriptor_ < 0) return false;
    bool is_news = false;
    alignas(inotify_event) std::array<char, 4096> buffer{};
    for (ssize_t size = 0; (size = ::read(descriptor_, buffer.data(), buffer.size())) > 0;) {
        for (ssize_t at = 0; at < size;) {
            inotify_event event{};
            std::memcpy(&event, buffer.data() + at, sizeof event);
            const char* name = buffer.data() + at + sizeof event;
            const bool is_overflow = (event.mask & IN_Q_OVERFLOW) != 0;
            is_news = is_news || is_overflow || (event.len > 0 && std::string_view{name}.starts_with(prefix_));
            at += static_cast<ssize_t>(sizeof event + event.len);
        }
    }
    return is_news;
}

}  // namespace quadrat::firmware_io
