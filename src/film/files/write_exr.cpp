// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <exception>
#include <stdexcept>

#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>

#include "balcony/film.hpp"
#include "balcony/output_file.hpp"
#include "film/files/exr_channels.hpp"
#include "film/sums/film_arrays.hpp"

namespace balcony::render {

namespace {

// The stream of an output file for OpenEXR.
class ExrStream final : public Imf::OStream {
public:
    explicit ExrStream(std::ofstream& stream) : Imf::OStream("picture.exr"), stream_(stream) {}

    void write(const char* bytes, int count) override {
        stream_.write(bytes, count);
        require_good();
    }
    std::uint64_t tellp() override { return static_cast<std::uint64_t>(stream_.tellp()); }
    void seekp(std::uint64_t position) override {
        stream_.seekp(static_cast<std::streamoff>(position));
        require_good();
    }

private:
    void require_good() const {
        if (!stream_) {
            throw std::runtime_error("writing failed");
        }
    }

    std::ofstream& stream_;
};

void write_rows(const Film& film, Imf::OStream& stream) {
    const Region& window = film.window;
    const std::vector<ChannelGroup> groups = channel_groups(film);
    Imf::OutputFile output(stream, exr_header(film, window, groups));
    ChannelValues values(groups);
    const std::size_t rows_at_once = values.rows_at_once(window.width);
    for (std::size_t first = 0; first < window.height; first += rows_at_once) {
        const Region band{window.x, window.y + first, window.width,
                          std::min(rows_at_once, window.height - first)};
        output.setFrameBuffer(values.read(film, band));
        output.writePixels(static_cast<int>(band.height));
    }
}

}  // namespace

Diagnostics write_exr(const Film& film, const std::filesystem::path& file) {
    if (Diagnostics found = check_sizes(film); !found.empty()) {
        return found;
    }
    OutputFile output(file);
    try {
        ExrStream stream(output.stream());
        write_rows(film, stream);
    } catch (const std::exception& failed) {
        // The reason is the stream's, or else OpenEXR's.
        return {output.stream() ? exr_failure(file, failed) : output.failure()};
    }
    return output.commit();
}

}  // namespace balcony::render
