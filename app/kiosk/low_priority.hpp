// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quadrat::kiosk {

// From now on the calling thread gives way to the one that draws.
void lower_priority();

}  // namespace quadrat::kiosk
