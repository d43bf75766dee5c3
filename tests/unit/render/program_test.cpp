// SPDX-License-Identifier: Apache-2.0
#include "render/gl/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>

#include "base/error.hpp"
#include "render/choose/crowd.hpp"
#include "render/choose/view_block.hpp"
#include "render/passes/mirror.hpp"
#include "unit/render/gpu_fixture.hpp"

namespace quadrat::render::gl {
namespace {

using testing::HasSubstr;

class Programs : public Gpu {};

GLint offset_of(GLuint program, const char* name) {
    const GLuint index = glGetProgramResourceIndex(program, GL_UNIFORM, name);
    if (index == GL_INVALID_INDEX) return -1;
    const GLenum wanted = GL_OFFSET;
    GLint offset = -1;
    glGetProgramResourceiv(program, GL_UNIFORM, index, 1, &wanted, 1, nullptr, &offset);
    return offset;
}

// std140 blocks keep members no shader reads, so one program shows them all.
TEST_F(Programs, LayTheViewBlockOutAsTheStructThatFillsIt) {
    using choose::ViewBlock;
    const Program sky("sky.vert", "sky.frag");
    const std::pair<const char*, std::size_t> members[] = {
        {"ViewBlock.clip_from_world", offsetof(ViewBlock, clip_from_world)},
        {"ViewBlock.eye_seconds", offsetof(ViewBlock, eye_seconds)},
        {"ViewBlock.to_sun", offsetof(ViewBlock, to_sun)},
        {"ViewBlock.to_glow", offsetof(ViewBlock, to_glow)},
        {"ViewBlock.sunlight", offsetof(ViewBlock, sunlight)},
        {"ViewBlock.ambient[0]", offsetof(ViewBlock, ambient)},
        {"ViewBlock.scales", offsetof(ViewBlock, scales)},
        {"ViewBlock.haze_colour", offsetof(ViewBlock, haze_colour)},
        {"ViewBlock.haze_sunward", offsetof(ViewBlock, haze_sunward)},
        {"ViewBlock.mist", offsetof(ViewBlock, mist)},
        {"ViewBlock.shallow_water", offsetof(ViewBlock, shallow_water)},
        {"ViewBlock.deepening", offsetof(ViewBlock, deepening)},
        {"ViewBlock.mirrored", offsetof(ViewBlock, mirrored)},
        {"ViewBlock.disc", offsetof(ViewBlock, disc)},
        {"ViewBlock.glare", offsetof(ViewBlock, glare)},
        {"ViewBlock.cloud_turn[0]", offsetof(ViewBlock, cloud_turn)},
        {"ViewBlock.cloud_place[0]", offsetof(ViewBlock, cloud_place)},
        {"ViewBlock.shadow_turn", offsetof(ViewBlock, shadow_turn)},
        {"ViewBlock.shadow_place", offsetof(ViewBlock, shadow_place)},
        {"ViewBlock.cloud_shaded", offsetof(ViewBlock, cloud_shaded)},
        {"ViewBlock.cloud_gain", offsetof(ViewBlock, cloud_gain)}};
    for (const auto& [name, offset] : members)
        EXPECT_EQ(offset_of(sky.name(), name), static_cast<GLint>(offset)) << name;
    const GLenum size = GL_BUFFER_DATA_SIZE;
    GLint bytes = 0;
    glGetProgramResourceiv(sky.name(), GL_UNIFORM_BLOCK, 0, 1, &size, 1, nullptr, &bytes);
    EXPECT_EQ(bytes, static_cast<GLint>(sizeof(ViewBlock)));
    EXPECT_EQ(choose::kViewBlockBytes % 256, 0U);
}

TEST_F(Programs, LayTheMirrorOutAsTheStructThatFillsIt) {
    using passes::MirrorBlock;
    const Program water("water.vert", "water.frag");
    const std::pair<const char*, std::size_t> members[] = {{"MirrorBlock.place", offsetof(MirrorBlock, place)},
                                                           {"MirrorBlock.ripple", offsetof(MirrorBlock, ripple)},
                                                           {"MirrorBlock.shore_m[0]", offsetof(MirrorBlock, shore_m)}};
    for (const auto& [name, offset] : members)
        EXPECT_EQ(offset_of(water.name(), name), static_cast<GLint>(offset)) << name;
    EXPECT_EQ(sizeof(MirrorBlock), (2 + scene::Mirror::kBearings / 4) * sizeof(glm::vec4));
}

TEST_F(Programs, ReadAnInstanceAsTheStructThatFillsIt) {
    const Program leaves("leaves.vert", "leaves.frag");
    EXPECT_EQ(glGetAttribLocation(leaves.name(), "root_scale"), 8);
    EXPECT_EQ(glGetAttribLocation(leaves.name(), "turn_grown_share"), 9);
    EXPECT_EQ(glGetAttribLocation(leaves.name(), "wind_sun_through"), 10);
    EXPECT_EQ(glGetAttribLocation(leaves.name(), "air"), 11);
    EXPECT_EQ(glGetAttribLocation(leaves.name(), "half_tint_enlarged"), 12);
    const Program crown("crown.vert", "lit.frag");
    EXPECT_EQ(glGetAttribLocation(crown.name(), "becoming"), 13);
    EXPECT_EQ(sizeof(choose::Instance), 60U);
}

TEST_F(Programs, NameFileAndLineOfAnErrorInAnInclude) {
    static constexpr std::string_view kFiles[] = {"shaders/broken.frag", "shaders/common/oops.glsl"};
    const shaders::Source broken{
        "broken.frag",
        "#version 310 es\nprecision highp float;\n#line 1 1\nfloat half_of(float x) {\n    return "
        "y * 0.5;\n}\n#line 4 0\nvoid main() {}\n",
        kFiles};
    try {
        const Program program(shaders::source("sky.vert"), broken);
        FAIL() << "it compiled";
    } catch (const base::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("shader broken.frag"));
        EXPECT_THAT(error.what(), HasSubstr("shaders/common/oops.glsl:2"));
    }
}

TEST(ShaderLog, KeepsLinesThatNameNoFile) {
    static constexpr std::string_view kFiles[] = {"shaders/a.frag"};
    const shaders::Source source{"a.frag", "", kFiles};
    EXPECT_EQ(with_file_names("0:3(7): error: x\nlinking failed\n7:1: y", source),
              "shaders/a.frag:3(7): error: x\nlinking failed\n7:1: y");
}

TEST(ShaderLog, NamesTheFileInNvidiasWordsToo) {
    static constexpr std::string_view kFiles[] = {"shaders/a.frag", "shaders/b.glsl"};
    const shaders::Source source{"a.frag", "", kFiles};
    EXPECT_EQ(with_file_names("1(2) : error C1503: undefined variable \"y\"\n0(x) : error\n1(2\n2(3) : x", source),
              "shaders/b.glsl:2: error C1503: undefined variable \"y\"\n0(x) : error\n1(2\n2(3) : x");
}

TEST(ShaderSources, HoldEveryIncludeInPlace) {
    EXPECT_GE(shaders::sources().size(), 10U);
    for (const shaders::Source& source : shaders::sources()) {
        EXPECT_EQ(source.text.find("#include"), std::string_view::npos) << source.name;
        EXPECT_TRUE(source.text.starts_with("#version 310 es\n")) << source.name;
        EXPECT_THAT(std::string(source.files[0]), testing::EndsWith(std::string(source.name)));
    }
}

}  // namespace
}  // namespace quadrat::render::gl
