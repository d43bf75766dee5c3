// SPDX-License-Identifier: Apache-2.0
#pragma once

// Who only hands parameters on need not be compiled anew for another row of the parameter table.
namespace quadrat::scene {

struct TreeParameters;
struct LandParameters;
struct SkyParameters;
struct SceneParameters;

}  // namespace quadrat::scene
