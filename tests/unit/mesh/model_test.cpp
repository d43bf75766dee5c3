// SPDX-License-Identifier: Apache-2.0
#include "mesh/model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <nlohmann/json.hpp>

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

TEST(Model, AsTextHoldsTheBytesThatTheBinaryFormHolds) {
    const std::string text = to_gltf(grey_triangle());
    const nlohmann::json gltf = nlohmann::json::parse(text);
    const std::string uri = gltf["buffers"][0]["uri"];
    constexpr std::string_view kHead = "data:application/octet-stream;base64,";
    ASSERT_EQ(uri.substr(0, kHead.size()), kHead);
    const std::string_view encoded = std::string_view(uri).substr(kHead.size());
    // RFC 4648 backwards.
    std::string bytes;
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : encoded) {
        if (c == '=') break;
        bits = bits << 6U | static_cast<std::uint32_t>(kLetters.find(c));
        if ((held += 6) >= 8) bytes += static_cast<char>(bits >> static_cast<unsigned>(held -= 8) & 255U);
    }
    EXPECT_EQ(bytes.size(), gltf["buffers"][0]["byteLength"]);
    EXPECT_EQ(encoded.size() % 4, 0U);
    EXPECT_THAT(to_glb(grey_triangle()), HasSubstr(bytes)) << "the same, as a chunk";
}

TEST(Model, IsWrittenAsItsFileIsNamed) {
    EXPECT_EQ(model_file(grey_triangle(), ".obj"), to_obj(grey_triangle()));
    EXPECT_EQ(model_file(grey_triangle(), ".glb").substr(0, 4), "glTF");
    EXPECT_EQ(model_file(grey_triangle(), ".gltf").front(), '{');
}

}  // namespace
}  // namespace quadrat::mesh
