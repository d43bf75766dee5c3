// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/types.h>

#include <string>

namespace quadrat::display::testing {

// An X server without a screen, for as long as this lives; DISPLAY points to it and to nothing else.
// Throws with instructions when there is no Xvfb: the window is tested or the test fails.
class VirtualDesktop {
  public:
    VirtualDesktop();
    ~VirtualDesktop();
    VirtualDesktop(const VirtualDesktop&) = delete;
    VirtualDesktop& operator=(const VirtualDesktop&) = delete;
    const std::string& name() const { return name_; }  // ":12"

  private:
    pid_t server_ = -1;
    std::string name_;
};

}  // namespace quadrat::display::testing
