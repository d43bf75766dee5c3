// SPDX-License-Identifier: Apache-2.0
#include "mesh/model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace quadrat::mesh {
namespace {

using testing::HasSubstr;

Model grey_triangle() {
    Mesh mesh;
    mesh.positions_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.indices = {0, 1, 2};
    Model model;
    model.parts.push_back({"wood", mesh, {0.2140411F, 1, 0}});  // half of sRGB's code values, all, nothing
    return model;
}

TEST(Model, ColoursOfAnObjAreSrgbAndItsHeadSaysSo) {
    const std::string obj = to_obj(grey_triangle());
    EXPECT_THAT(obj.substr(0, obj.find('\n')), HasSubstr("sRGB"));
    EXPECT_THAT(obj, HasSubstr("v 1 0 0 0.5 1 0\n"));
}

TEST(Model, ColoursOfAGlbAreLinear) {
    EXPECT_THAT(to_glb(grey_triangle()), HasSubstr("\"baseColorFactor\":[0.2140411,1,0,1]"));
}

}  // namespace
}  // namespace quadrat::mesh
