// SPDX-License-Identifier: Apache-2.0
#include "base/owned.hpp"

#include <unistd.h>

namespace quadrat::base {

void CloseDescriptor::operator()(int fd) const noexcept { ::close(fd); }

}  // namespace quadrat::base
