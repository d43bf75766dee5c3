// SPDX-License-Identifier: Apache-2.0
#include "render/gl/limits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "render/gl/buffer.hpp"
#include "render/gl/program.hpp"
#include "render/gl/texture.hpp"
#include "support/source_tree.hpp"
#include "unit/render/gpu_fixture.hpp"

namespace quadrat::render::gl {
namespace {

using limits::breaches;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Limits : public Gpu {
  protected:
    static void link(std::string_view vertex, std::string_view fragment) {
        static constexpr std::string_view kFiles[] = {"test"};
        Program program({"test.vert", vertex, kFiles}, {"test.frag", fragment, kFiles});
    }
    static constexpr std::string_view kVertex =
        "#version 310 es\nlayout(location = 0) in vec4 p;\nvoid main() { gl_Position = p; }\n";
    static constexpr std::string_view kFragment =
        "#version 310 es\nprecision highp float;\nlayout(binding = 0) uniform sampler2D t;\n"
        "layout(location = 0) out vec4 c;\nvoid main() { c = texture(t, vec2(0.5)); }\n";
};

TEST_F(Limits, FindNothingWrongWithAPlainProgram) {
    link(kVertex, kFragment);
    EXPECT_THAT(breaches(), IsEmpty());
}

TEST_F(Limits, CatchATextureFetchInTheVertexStage) {
    link(
        "#version 310 es\nlayout(location = 0) in vec4 p;\nlayout(binding = 1) uniform highp sampler2D heights;\n"
        "void main() { gl_Position = p + textureLod(heights, p.xy, 0.0); }\n",
        kFragment);
    EXPECT_THAT(breaches(), ElementsAre(HasSubstr("heights is fetched in the vertex stage")));
}

TEST_F(Limits, CatchAStorageBlockInTheVertexStage) {
    GLint allowed = 0;
    glGetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &allowed);
    const std::string_view vertex =
        "#version 310 es\nlayout(location = 0) in vec4 p;\nlayout(std430, binding = 0) readonly buffer Roots { vec4 "
        "at[]; "
        "} roots;\nvoid main() { gl_Position = p + roots.at[gl_InstanceID]; }\n";
    if (allowed == 0) GTEST_SKIP() << "this GPU refuses it by itself";
    link(vertex, kFragment);
    EXPECT_THAT(breaches(), ElementsAre(HasSubstr("storage block Roots in the vertex stage")));
}

TEST_F(Limits, CatchATextureThatIsTooLarge) {
    TextureShape shape;
    shape.width = 4097;
    shape.height = 1;
    shape.channels = 1;
    const Texture2D texture(shape);
    EXPECT_THAT(breaches(), ElementsAre(HasSubstr("a texture of 4097x1")));
}

TEST_F(Limits, CatchAUniformBlockThatIsNotAligned) {
    StreamBuffer buffer(GL_UNIFORM_BUFFER);
    const std::vector<std::byte> bytes(1024);
    buffer.fill<std::byte>(bytes);
    bind_uniforms(buffer, 0, 256, 256);
    EXPECT_THAT(breaches(), IsEmpty());
    bind_uniforms(buffer, 0, 64, 256);
    EXPECT_THAT(breaches(), ElementsAre(HasSubstr("a uniform block at byte 64")));
}

TEST_F(Limits, CatchFormatsThatV3dCannotFilterOrHold) {
    limits::check_texture(16, 16, GL_RGBA32F, limits::Filter::Nearest);
    limits::check_texture(16, 16, GL_RGBA16F, limits::Filter::Linear);
    EXPECT_THAT(breaches(), IsEmpty());
    limits::check_texture(16, 16, GL_RGBA32F, limits::Filter::Linear);
    limits::check_texture(16, 16, 0x805B, limits::Filter::Nearest);  // RGBA16
    EXPECT_THAT(breaches(), ElementsAre(HasSubstr("filtered 32 bit float"), HasSubstr("16 bit normalised")));
}

TEST_F(Limits, CatchAnExtensionThatV3dLacksAndAnIndirectDraw) {
    limits::has_extension("GL_KHR_debug");
    limits::check_draw("glDrawElementsInstanced");
    EXPECT_THAT(breaches(), IsEmpty());
    limits::has_extension("GL_EXT_texture_norm16");
    limits::check_draw("glDrawElementsIndirect");
    limits::check_attribute(16);
    EXPECT_THAT(breaches(), ElementsAre(HasSubstr("GL_EXT_texture_norm16"), HasSubstr("glDrawElementsIndirect"),
                                        HasSubstr("vertex attribute 16")));
}

TEST_F(Limits, RecordEachBreachOnce) {
    limits::check_attribute(20);
    limits::check_attribute(20);
    EXPECT_EQ(breaches().size(), 1U);
}

TEST(SourceLimits, CatchEachBanInItsLine) {
    EXPECT_THAT(limits::breaches_in_shader("a.vert", "void main() {\n  vec4 h = textureLod(t, p, 0.0);\n}"),
                ElementsAre(HasSubstr("a.vert:2:")));
    EXPECT_THAT(limits::breaches_in_shader("a.frag", "vec4 h = textureLod(t, p, 0.0);"), IsEmpty());
    EXPECT_THAT(limits::breaches_in_shader("a.frag", "#extension GL_EXT_gpu_shader5 : require"),
                ElementsAre(HasSubstr("lacks GL_EXT_gpu_shader5")));
    EXPECT_THAT(limits::breaches_in_shader("a.frag", "// discard is not used here"), IsEmpty());
    EXPECT_THAT(limits::breaches_in_shader("a.frag", "if (a < 0.5) discard;"), ElementsAre(HasSubstr("a.frag:1:")));
    EXPECT_THAT(limits::breaches_in_code("a.cpp", "\nglDrawArraysIndirect(GL_TRIANGLES, nullptr);"),
                ElementsAre(HasSubstr("a.cpp:2:")));
    EXPECT_THAT(limits::breaches_in_code("a.cpp", "glMultiDrawElementsIndirectEXT(a, b);"), testing::SizeIs(1));
    EXPECT_THAT(limits::breaches_in_code("a.cpp", "glReadPixels(0, 0);"), testing::SizeIs(1));
}

TEST(SourceLimits, HoldForEveryShaderAndForTheRendererItself) {
    std::size_t checked = 0;
    for (const auto& file : tests::source_files({"shaders"}, {".vert", ".frag", ".glsl"})) {
        EXPECT_THAT(limits::breaches_in_shader(file.path, file.text), IsEmpty());
        ++checked;
    }
    EXPECT_GT(checked, 10U);
    for (const auto& file : tests::source_files({"app/render"}, {".cpp", ".hpp"})) {
        // Taking a picture reads back by definition, a glimpse does so into a buffer and is fetched frames later, and a
        // processor that spreads one has no tiles; the limits name what they ban and ask on behalf of all.
        constexpr std::string_view kExempt[] = {"app/render/read_pixels.cpp", "app/render/glimpse.cpp",
                                                "app/render/gl/processor_spread.cpp", "app/render/gl/limits.cpp"};
        if (std::ranges::find(kExempt, file.path) != std::end(kExempt)) continue;
        EXPECT_THAT(limits::breaches_in_code(file.path, file.text), IsEmpty());
    }
}

}  // namespace
}  // namespace quadrat::render::gl
