// SPDX-License-Identifier: Apache-2.0
#include "kiosk/low_priority.hpp"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace quadrat::kiosk {

void lower_priority() {
    constexpr int kNice = 10;
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), kNice);
}

}  // namespace quadrat::kiosk
