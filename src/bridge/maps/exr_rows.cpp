// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/maps/exr_rows.hpp"

#include <exception>
#include <optional>
#include <stdexcept>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

namespace balcony::bridge {

namespace {

/// What OpenEXR writes to; a failure throws.
class ExrStream final : public Imf::OStream {
public:
    explicit ExrStream(std::ostream& stream) : Imf::OStream("picture"), stream_(stream) {}

    void write(const char* bytes, int count) override { check(stream_.write(bytes, count)); }
    std::uint64_t tellp() override { return static_cast<std::uint64_t>(stream_.tellp()); }
    void seekp(std::uint64_t position) override {
        check(stream_.seekp(static_cast<std::streamoff>(position)));
    }

private:
    static void check(const std::ostream& stream) {
        if (!stream) {
            throw std::runtime_error("the file cannot be written");
        }
    }

    std::ostream& stream_;
};

}  // namespace

struct ExrRows::State {
    explicit State(std::ostream& stream) : to(stream) {}

    ExrStream to;
    std::size_t width = 0;
    std::vector<std::string> channels;
    std::optional<Imf::OutputFile> output;
};

ExrRows::ExrRows(std::ostream& stream, std::size_t width, std::size_t height,
                 std::vector<std::string> channels, const Attributes& attributes)
    : stream_(stream), state_(std::make_unique<State>(stream)) {
    Imf::Header header(static_cast<int>(width), static_cast<int>(height));
    header.compression() = Imf::NO_COMPRESSION;
    for (const std::string& channel : channels) {
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    }
    for (const auto& [name, text] : attributes) {
        header.insert(name, Imf::StringAttribute(text));
    }
    state_->width = width;
    state_->channels = std::move(channels);
    try {
        constexpr int no_threads = 0;
        state_->output.emplace(state_->to, header, no_threads);
    } catch (const std::exception&) {
        stream.setstate(std::ios::failbit);
    }
}

ExrRows::~ExrRows() = default;

bool ExrRows::write(const RowSpan& rows, const float* values) {
    if (!stream_) {
        return false;
    }
    const std::size_t pixel = state_->channels.size() * sizeof(float);
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < state_->channels.size(); ++i) {
        // OpenEXR takes buffers that it could write to, and counts from the picture's first row.
        buffer.insert(
            state_->channels[i],
            Imf::Slice::Make(Imf::FLOAT, const_cast<float*>(values + i),
                             Imath::V2i(0, static_cast<int>(rows.first)),
                             static_cast<std::int64_t>(state_->width),
                             static_cast<std::int64_t>(rows.count), pixel, state_->width * pixel));
    }
    try {
        state_->output->setFrameBuffer(buffer);
        state_->output->writePixels(static_cast<int>(rows.count));
    } catch (const std::exception&) {
        stream_.setstate(std::ios::failbit);
    }
    return static_cast<bool>(stream_);
}

bool ExrRows::finish() {
    // Writes the table of the rows' places.
    state_->output.reset();
    return static_cast<bool>(stream_);
}

}  // namespace balcony::bridge
