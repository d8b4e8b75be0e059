// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A library with the functions of Open Image Denoise 2 that Balcony calls. Its filter halves the
// colour, and refuses pictures of 13 pixels width and pictures without features.

#include <cstddef>
#include <map>
#include <string>

namespace {

struct Image {
    float* pixels = nullptr;
    std::size_t count = 0;
};

struct Device {
    const char* error = nullptr;
};

struct Filter {
    Device* device = nullptr;
    std::map<std::string, Image> images;
    std::size_t width = 0;
    bool high_dynamic_range = false;
};

}  // namespace

extern "C" {

Device* oidnNewDevice(int type) { return type == 1 ? new Device : nullptr; }
void oidnCommitDevice(Device*) {}
void oidnReleaseDevice(Device* device) { delete device; }

int oidnGetDeviceError(Device* device, const char** message) {
    *message = device->error;
    return device->error != nullptr ? 1 : 0;
}

Filter* oidnNewFilter(Device* device, const char* type) {
    return std::string(type) == "RT" ? new Filter{device, {}, 0, false} : nullptr;
}

void oidnSetSharedFilterImage(Filter* filter, const char* name, void* pixels, int format,
                              std::size_t width, std::size_t height, std::size_t, std::size_t,
                              std::size_t) {
    if (format == 3) {
        filter->images[name] = {static_cast<float*>(pixels), 3 * width * height};
        filter->width = width;
    }
}

void oidnSetFilterBool(Filter* filter, const char* name, bool value) {
    filter->high_dynamic_range = std::string(name) == "hdr" && value;
}

void oidnCommitFilter(Filter*) {}

void oidnExecuteFilter(Filter* filter) {
    if (filter->width == 13) {
        filter->device->error = "13 is unlucky";
    } else if (filter->images.size() != 4 || !filter->high_dynamic_range) {
        filter->device->error = "something is missing";
    } else {
        for (std::size_t i = 0; i < filter->images["output"].count; ++i) {
            filter->images["output"].pixels[i] = 0.5F * filter->images["color"].pixels[i];
        }
    }
}

void oidnReleaseFilter(Filter* filter) { delete filter; }

}  // extern "C"
