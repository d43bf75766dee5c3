// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/srgb.hpp"
#include "pictures/images/module.hpp"
#include "pictures/images/png_chunks.hpp"
#include "pictures/images/tiff_nodata.hpp"

namespace quadrat::pictures {
namespace {

namespace oiio = OIIO;

// A text chunk that every picture tool keeps and shows.
constexpr const char* kSceneKey = "quadrat:scene";

// OpenImageIO may say several lines; ours is one.
[[noreturn]] void fail(const std::string& name, std::string what) {
    std::ranges::replace(what, '\n', ' ');
    throw base::InputError(fmt::format("{}: {}", name, what));
}

struct Format {
    std::string_view ending;
    const char* name;        // OpenImageIO's
    std::string_view start;  // of such a file
};
constexpr std::array kFormats{Format{".png", "png", {"\x89PNG\r\n\x1a\n", 8}},
                              Format{".exr", "openexr", "\x76\x2f\x31\x01"},
                              Format{".tif", "tiff", {"II*\0", 4}},
                              Format{".tiff", "tiff", {"MM\0*", 4}},
                              Format{".tif", "tiff", {"II+\0", 4}},
                              Format{".tiff", "tiff", {"MM\0+", 4}}};

const char* format_named(const PictureName& file) {
    const auto* const found = std::ranges::find(kFormats, std::string_view(file.ending), &Format::ending);
    if (found == kFormats.end()) fail(file.whole, "cannot write a picture of this kind; use .png, .exr or .tif");
    return found->name;
}

const char* format_of(std::string_view bytes) {  // nullptr: none that we read
    if (bytes.size() > 1 && bytes[0] == 'P' && std::string_view("1234567fF").find(bytes[1]) != std::string_view::npos)
        return "pnm";
    const auto* const found =
        std::ranges::find_if(kFormats, [&](const Format& format) { return bytes.starts_with(format.start); });
    return found == kFormats.end() ? nullptr : found->name;
}

// A picture that lies in memory: OpenImageIO would read more than a path out of a name with ? or % in it.
class InMemory {
  public:
    InMemory(std::string bytes, const std::string& name)
        : bytes_(std::move(bytes)), name_(name), reader_(bytes_.data(), bytes_.size()) {
        const char* const format = format_of(bytes_);
        if (format == nullptr) fail(name, "cannot read as a picture: it is no PNG, TIFF, EXR or PNM");
        input_ = oiio::ImageInput::create(format);
        if (!input_ || !input_->set_ioproxy(&reader_) || !input_->open(std::string("in memory.") + format, spec_))
            fail_to_read();
        if (spec_.width < 1 || spec_.height < 1 || spec_.width > kLargest || spec_.height > kLargest ||
            spec_.depth > 1 || spec_.nchannels < 1 || spec_.nchannels > kMostChannels)
            fail(name, fmt::format("it is {} by {} pixels; a picture has 1 to {} a side", spec_.width, spec_.height,
                                   kLargest));
    }
    const oiio::ImageSpec& spec() const { return spec_; }
    std::size_t pixel_count() const {
        return static_cast<std::size_t>(spec_.width) * static_cast<std::size_t>(spec_.height);
    }
    template <typename Sample>
    std::vector<Sample> samples(const oiio::TypeDesc& type) {
        std::vector<Sample> all(pixel_count() * static_cast<std::size_t>(spec_.nchannels));
        if (!input_->read_image(0, 0, 0, spec_.nchannels, type, all.data())) fail_to_read();
        return all;
    }

  private:
    static constexpr int kLargest = 16384;
    static constexpr int kMostChannels = 16;

    [[noreturn]] void fail_to_read() {
        fail(name_, fmt::format("cannot read as a picture: {}", input_ ? input_->geterror() : oiio::geterror()));
    }

    std::string bytes_;
    std::string name_;
    oiio::Filesystem::IOMemReader reader_;
    std::unique_ptr<oiio::ImageInput> input_;
    oiio::ImageSpec spec_;
};

// Not every writer tells of every failure: what it made is looked at before it counts.
void check_whole(const std::string& bytes, const std::string& name, const oiio::ImageSpec& spec) {
    if (bytes.starts_with(kFormats.front().start)) {
        const std::string damage = damage_of_png(bytes);
        if (!damage.empty()) fail(name, fmt::format("cannot write: {}", damage));
        return;
    }
    InMemory again(bytes, name);
    if (again.spec().width != spec.width || again.spec().height != spec.height)
        fail(name, "cannot write: it came out in another size");
    again.samples<float>(oiio::TypeDesc::FLOAT);
}

// The whole file, in the format of the name's ending, without the time of day that OpenImageIO would add.
std::string encoded(const PictureName& name, oiio::ImageSpec spec, const oiio::TypeDesc& type, const void* samples) {
    const std::string format = format_named(name);
    // An EXR's date is a text that may be empty; a TIFF's is left out where it is none.
    if (format == "openexr") spec.attribute("DateTime", "");
    if (format == "tiff") spec.attribute("DateTime", 0);
    const auto output = oiio::ImageOutput::create(format);
    std::vector<unsigned char> bytes;
    oiio::Filesystem::IOVecOutput in_memory(bytes);
    if (!output || !output->set_ioproxy(&in_memory) || !output->open("in memory." + format, spec) ||
        !output->write_image(type, samples) || !output->close())
        fail(name.whole, fmt::format("cannot write: {}", output ? output->geterror() : oiio::geterror()));
    std::string whole(bytes.begin(), bytes.end());
    if (format == "png") whole = with_texts_first(std::move(whole));
    check_whole(whole, name.whole, spec);
    return whole;
}

// EXR holds light, not code values.
std::vector<float> linear_samples(const mesh::Image& pixels) {
    std::vector<float> samples(pixels.bytes.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const bool is_alpha = pixels.channels == 4 && i % 4 == 3;
        samples[i] = is_alpha ? static_cast<float>(pixels.bytes[i]) / 255.0F
                              : base::linear_from_srgb(static_cast<float>(pixels.bytes[i]) / 255.0F);
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

std::string encode_picture(const PictureName& name, const mesh::Image& pixels, const std::string& json) {
    const bool is_exr = name.ending == ".exr";
    oiio::ImageSpec spec(pixels.width, pixels.height, pixels.channels,
                         is_exr ? oiio::TypeDesc::HALF : oiio::TypeDesc::UINT8);
    spec.attribute("Software", "quadrat");
    spec.attribute("png:compressionLevel", 4);
    if (!json.empty()) spec.attribute(kSceneKey, json);
    if (is_exr) return encoded(name, spec, oiio::TypeDesc::FLOAT, linear_samples(pixels).data());
    return encoded(name, spec, oiio::TypeDesc::UINT8, pixels.bytes.data());
}

std::string encode_field(const PictureName& name, const mesh::Field& field) {
    oiio::ImageSpec spec(field.columns, field.rows, 1, oiio::TypeDesc::FLOAT);
    spec.channelnames = {"Y"};
    return encoded(name, spec, oiio::TypeDesc::FLOAT, field.samples.data());
}

std::string encode_heights(const PictureName& name, const mesh::Field& field, float low, float high) {
    std::vector<std::uint16_t> samples(field.samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const float share = (field.samples[i] - low) / (high - low);
        samples[i] = static_cast<std::uint16_t>(std::lround(65535.0F * std::clamp(share, 0.0F, 1.0F)));
    }
    oiio::ImageSpec spec(field.columns, field.rows, 1, oiio::TypeDesc::UINT16);
    spec.attribute("png:compressionLevel", 4);
    return encoded(name, spec, oiio::TypeDesc::UINT16, samples.data());
}

// The largest number of an integer's kind; nothing for floats.
std::optional<float> largest_of(const oiio::TypeDesc& type) {
    switch (type.basetype) {
        case oiio::TypeDesc::UINT8:
            return 255.0F;
        case oiio::TypeDesc::INT8:
            return 127.0F;
        case oiio::TypeDesc::UINT16:
            return 65535.0F;
        case oiio::TypeDesc::INT16:
            return 32767.0F;
        case oiio::TypeDesc::UINT32:
            return 4294967295.0F;
        case oiio::TypeDesc::INT32:
            return 2147483647.0F;
        default:
            return std::nullopt;
    }
}

GreyPicture read_grey(std::string bytes, const std::string& name) {
    const StandardErrorMuted muted;
    const std::optional<float> nodata = nodata_of_tiff(bytes);
    InMemory picture(std::move(bytes), name);
    const auto channels = static_cast<std::size_t>(picture.spec().nchannels);
    const std::vector<float> samples = picture.samples<float>(oiio::TypeDesc::FLOAT);
    const std::size_t colours = channels >= 3 ? 3 : 1;  // what follows is opacity
    const std::optional<float> largest = largest_of(picture.spec().format);
    GreyPicture grey{mesh::Field(picture.spec().width, picture.spec().height), std::nullopt, nodata};
    if (!picture.spec().format.is_signed()) grey.white = largest;
    for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
        float mean = 0;
        for (std::size_t c = 0; c < colours; ++c) mean += samples[i * channels + c] / static_cast<float>(colours);
        // OpenImageIO hands integers over as shares of their largest.
        grey.samples.samples[i] = largest ? mean * *largest : mean;
        if (largest && colours == 1) grey.samples.samples[i] = std::round(grey.samples.samples[i]);
    }
    return grey;
}

mesh::Image read_image(std::string bytes, const std::string& name) {
    InMemory picture(std::move(bytes), name);
    const auto channels = static_cast<std::size_t>(picture.spec().nchannels);
    const std::vector<std::uint8_t> samples = picture.samples<std::uint8_t>(oiio::TypeDesc::UINT8);
    mesh::Image image(picture.spec().width, picture.spec().height, 4);
    for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
        const std::uint8_t* const from = &samples[i * channels];
        for (std::size_t c = 0; c < 3; ++c) image.bytes[4 * i + c] = from[channels >= 3 ? c : 0];
        image.bytes[4 * i + 3] = channels >= 4 ? from[3] : 255;
    }
    return image;
}

std::optional<std::string> scene_inside(std::string bytes, const std::string& name) {
    const StandardErrorMuted muted;
    const InMemory picture(with_texts_first(std::move(bytes)), name);
    const std::string json = picture.spec().get_string_attribute(kSceneKey);
    if (json.empty()) return std::nullopt;
    return json;
}

constexpr ImageFiles kFiles{encode_picture, encode_field, encode_heights, read_grey, read_image, scene_inside};

}  // namespace
}  // namespace quadrat::pictures

const quadrat::pictures::ImageFiles* quadrat_image_files() { return &quadrat::pictures::kFiles; }
