// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "film/denoise/image_denoise_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

namespace balcony::render {

// The part of the library's C interface that is the same in its versions 1 and 2.
struct ImageDenoiseLibrary::Functions {
    using Device = void*;
    using Filter = void*;
    static constexpr int device_of_processor = 1;
    static constexpr int format_of_three_floats = 3;

    Functions() = default;
    Functions(const Functions&) = delete;
    Functions& operator=(const Functions&) = delete;
    ~Functions() {
        if (library != nullptr) {
            dlclose(library);
        }
    }

    void* library = nullptr;
    Device (*new_device)(int type) = nullptr;
    void (*commit_device)(Device) = nullptr;
    void (*release_device)(Device) = nullptr;
    int (*device_error)(Device, const char** message) = nullptr;
    Filter (*new_filter)(Device, const char* type) = nullptr;
    void (*set_image)(Filter, const char* name, void* pixels, int format, std::size_t width,
                      std::size_t height, std::size_t offset, std::size_t pixel_stride,
                      std::size_t row_stride) = nullptr;
    void (*set_flag)(Filter, const char* name, bool value) = nullptr;
    void (*commit_filter)(Filter) = nullptr;
    void (*execute_filter)(Filter) = nullptr;
    void (*release_filter)(Filter) = nullptr;
};

namespace {

template <class Function>
bool find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
}

}  // namespace

std::optional<ImageDenoiseLibrary> ImageDenoiseLibrary::load(const std::filesystem::path& file) {
    std::vector<std::string> names{"libOpenImageDenoise.so.2", "libOpenImageDenoise.so.1",
                                   "libOpenImageDenoise.so.0", "libOpenImageDenoise.so"};
    if (!file.empty()) {
        names = {file.string()};
    }
    for (const std::string& name : names) {
        auto f = std::make_shared<Functions>();
        f->library = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (f->library == nullptr) {
            continue;
        }
        // Version 2 has another name for flags.
        const bool complete = find(f->library, "oidnNewDevice", f->new_device) &&
                              find(f->library, "oidnCommitDevice", f->commit_device) &&
                              find(f->library, "oidnReleaseDevice", f->release_device) &&
                              find(f->library, "oidnGetDeviceError", f->device_error) &&
                              find(f->library, "oidnNewFilter", f->new_filter) &&
                              find(f->library, "oidnSetSharedFilterImage", f->set_image) &&
                              (find(f->library, "oidnSetFilterBool", f->set_flag) ||
                               find(f->library, "oidnSetFilter1b", f->set_flag)) &&
                              find(f->library, "oidnCommitFilter", f->commit_filter) &&
                              find(f->library, "oidnExecuteFilter", f->execute_filter) &&
                              find(f->library, "oidnReleaseFilter", f->release_filter);
        if (complete) {
            ImageDenoiseLibrary made;
            made.functions_ = std::move(f);
            made.name_ = name;
            return made;
        }
    }
    return std::nullopt;
}

Diagnostics ImageDenoiseLibrary::filter(std::size_t width, std::size_t height,
                                        std::vector<float>& color, std::vector<float>& albedo,
                                        std::vector<float>& normal) const {
    const Functions& f = *functions_;
    Functions::Device device = f.new_device(Functions::device_of_processor);
    if (device == nullptr) {
        return {error(Kind::environment, fmt::format("{} cannot be started", name_))};
    }
    f.commit_device(device);
    Functions::Filter filter = f.new_filter(device, "RT");
    if (filter != nullptr) {
        const auto set = [&](const char* name, std::vector<float>& pixels) {
            f.set_image(filter, name, pixels.data(), Functions::format_of_three_floats, width,
                        height, 0, 0, 0);
        };
        std::vector<float> output(color.size());
        set("color", color);
        set("albedo", albedo);
        set("normal", normal);
        set("output", output);
        f.set_flag(filter, "hdr", true);
        f.commit_filter(filter);
        f.execute_filter(filter);
        f.release_filter(filter);
        color = std::move(output);
    }
    const char* message = nullptr;
    const bool failed = f.device_error(device, &message) != 0 || filter == nullptr;
    Diagnostics found;
    if (failed) {
        found.push_back(error(Kind::environment,
                              fmt::format("{} failed: {}", name_,
                                          message != nullptr ? message : "it has no filter")));
    }
    f.release_device(device);
    return found;
}

}  // namespace balcony::render
