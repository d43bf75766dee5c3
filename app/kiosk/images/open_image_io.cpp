// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "kiosk/images/module.hpp"

namespace quadrat::kiosk {
namespace {

namespace oiio = OIIO;

// A text chunk that every picture tool keeps and shows.
constexpr const char* kSceneKey = "quadrat:scene";

// OpenImageIO may say several lines; ours is one.
[[noreturn]] void fail(const std::string& name, std::string what) {
    std::ranges::replace(what, '\n', ' ');
    throw base::InputError(fmt::format("{}: {}", name, what));
}

std::unique_ptr<oiio::ImageOutput> output_for(const std::filesystem::path& path, const std::string& name) {
    auto output = oiio::ImageOutput::create(path.string());
    if (!output)
        fail(name, fmt::format("cannot write a picture of this kind ({}); use .png or .exr", oiio::geterror()));
    return output;
}

void write(oiio::ImageOutput& output, const std::filesystem::path& path, const std::string& name,
           const oiio::ImageSpec& spec, const oiio::TypeDesc& type, const void* samples) {
    if (!output.open(path.string(), spec) || !output.write_image(type, samples) || !output.close())
        fail(name, fmt::format("cannot write: {}", output.geterror()));
}

float linear_of(std::uint8_t srgb) {
    const float v = static_cast<float>(srgb) / 255.0F;
    return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}

// EXR holds light, not code values.
std::vector<float> linear_samples(const mesh::Image& pixels) {
    std::vector<float> samples(pixels.bytes.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const bool is_alpha = pixels.channels == 4 && i % 4 == 3;
        samples[i] = is_alpha ? static_cast<float>(pixels.bytes[i]) / 255.0F : linear_of(pixels.bytes[i]);
    }
    return samples;
}

// libpng prints what it also reports; while one of these lives, standard error goes nowhere.
class StandardErrorMuted {
  public:
    StandardErrorMuted() : kept_(::dup(STDERR_FILENO)) {
        const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (kept_ >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
        if (nowhere >= 0) ::close(nowhere);
    }
    ~StandardErrorMuted() {
        if (kept_ < 0) return;
        ::dup2(kept_, STDERR_FILENO);
        ::close(kept_);
    }
    StandardErrorMuted(const StandardErrorMuted&) = delete;
    StandardErrorMuted& operator=(const StandardErrorMuted&) = delete;

  private:
    int kept_;
};

void write_image_file(const std::filesystem::path& path, const std::string& name, const mesh::Image& pixels,
                      const std::string& json) {
    const auto output = output_for(path, name);
    const bool is_exr = path.extension() == ".exr";
    oiio::ImageSpec spec(pixels.width, pixels.height, pixels.channels,
                         is_exr ? oiio::TypeDesc::HALF : oiio::TypeDesc::UINT8);
    spec.attribute("Software", "quadrat");
    spec.attribute("png:compressionLevel", 4);
    if (!json.empty()) spec.attribute(kSceneKey, json);
    if (is_exr)
        write(*output, path, name, spec, oiio::TypeDesc::FLOAT, linear_samples(pixels).data());
    else
        write(*output, path, name, spec, oiio::TypeDesc::UINT8, pixels.bytes.data());
}

void write_field_file(const std::filesystem::path& path, const std::string& name, const mesh::Field& field) {
    const auto output = output_for(path, name);
    oiio::ImageSpec spec(field.columns, field.rows, 1, oiio::TypeDesc::FLOAT);
    spec.channelnames = {"Y"};
    write(*output, path, name, spec, oiio::TypeDesc::FLOAT, field.samples.data());
}

std::size_t write_height_picture(const std::filesystem::path& path, const std::string& name, const mesh::Field& field,
                                 float low, float high) {
    std::vector<std::uint16_t> samples(field.samples.size());
    std::size_t cut = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const float share = (field.samples[i] - low) / (high - low);
        cut += share < 0 || share > 1;
        samples[i] = static_cast<std::uint16_t>(std::lround(65535.0F * std::clamp(share, 0.0F, 1.0F)));
    }
    const auto output = output_for(path, name);
    oiio::ImageSpec spec(field.columns, field.rows, 1, oiio::TypeDesc::UINT16);
    spec.attribute("png:compressionLevel", 4);
    write(*output, path, name, spec, oiio::TypeDesc::UINT16, samples.data());
    return cut;
}

mesh::Field read_mask_file(const std::filesystem::path& path) {
    constexpr int kLargest = 8193;
    constexpr std::array kKinds{"png", "tiff", "openexr", "pnm"};
    const StandardErrorMuted muted;
    const auto input = oiio::ImageInput::open(path.string());
    if (!input) fail(path.string(), fmt::format("cannot read as a picture: {}", oiio::geterror()));
    if (std::ranges::find(kKinds, std::string_view(input->format_name())) == kKinds.end())
        fail(path.string(),
             fmt::format("a {} picture cannot be a mask; use PNG, TIFF, EXR or PNM", input->format_name()));
    const oiio::ImageSpec spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > kLargest || spec.height > kLargest || spec.depth > 1)
        fail(path.string(),
             fmt::format("it is {} by {} pixels; a mask has 1 to {} a side", spec.width, spec.height, kLargest));
    const auto channels = static_cast<std::size_t>(std::max(spec.nchannels, 1));
    std::vector<float> samples(channels * static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height));
    if (!input->read_image(0, 0, 0, spec.nchannels, oiio::TypeDesc::FLOAT, samples.data()))
        fail(path.string(), fmt::format("cannot read as a picture: {}", input->geterror()));
    const std::size_t colours = channels >= 3 ? 3 : 1;  // what follows is opacity
    mesh::Field mask(spec.width, spec.height);
    for (std::size_t i = 0; i < mask.samples.size(); ++i) {
        for (std::size_t c = 0; c < colours; ++c)
            mask.samples[i] += samples[i * channels + c] / static_cast<float>(colours);
        if (!std::isfinite(mask.samples[i]))
            fail(path.string(), fmt::format("pixel {} {} is not a number", i % static_cast<std::size_t>(spec.width),
                                            i / static_cast<std::size_t>(spec.width)));
    }
    return mask;
}

mesh::Image read_image_file(const std::filesystem::path& path) {
    const auto input = oiio::ImageInput::open(path.string());
    if (!input) fail(path.string(), fmt::format("cannot read as a picture: {}", oiio::geterror()));
    const oiio::ImageSpec& spec = input->spec();
    oiio::ImageBuf picture(path.string());
    mesh::Image image(spec.width, spec.height, 4);
    const std::vector<int> order = spec.nchannels >= 4   ? std::vector<int>{0, 1, 2, 3}
                                   : spec.nchannels >= 3 ? std::vector<int>{0, 1, 2, -1}
                                                         : std::vector<int>{0, 0, 0, -1};
    const std::vector<float> fill{0, 0, 0, 1};
    const oiio::ImageBuf rgba = oiio::ImageBufAlgo::channels(picture, 4, order, fill);
    if (!rgba.get_pixels(oiio::get_roi(rgba.spec()), oiio::TypeDesc::UINT8, image.bytes.data()))
        fail(path.string(), fmt::format("cannot read as a picture: {}", rgba.geterror()));
    return image;
}

std::optional<std::string> scene_inside(const std::filesystem::path& path) {
    const StandardErrorMuted muted;
    const auto input = oiio::ImageInput::open(path.string());
    if (!input) fail(path.string(), fmt::format("cannot read as a picture: {}", oiio::geterror()));
    const std::string json = input->spec().get_string_attribute(kSceneKey);
    if (json.empty()) return std::nullopt;
    return json;
}

constexpr ImageFiles kFiles{write_image_file, write_field_file, write_height_picture,
                            read_mask_file,   read_image_file,  scene_inside};

}  // namespace
}  // namespace quadrat::kiosk

const quadrat::kiosk::ImageFiles* quadrat_image_files() { return &quadrat::kiosk::kFiles; }
