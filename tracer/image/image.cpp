#include "tracer/image/image.h"

#include <algorithm>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

#include "exact/io/failure.h"

namespace tribunal {
namespace {

std::uint8_t to_level(double x) {
  return x > 0 ? static_cast<std::uint8_t>(std::min(x, 1.0) * 255 + 0.5) : std::uint8_t{0};
}

}  // namespace

Pixel to_pixel(const Colour& c) { return {to_level(c.r), to_level(c.g), to_level(c.b)}; }

std::string to_png(const Image& image) {
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  std::string bytes;
  if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, image.pixels.data(), 3 * image.width)) {
    throw Failure(Exit::resources, "cannot encode an image of this size");
  }
  return bytes;
}

Image dimmed(const Image& image) {
  Image grey = image;
  for (Pixel& p : grey.pixels) {
    const int level = (2 * p[0] + 5 * p[1] + p[2]) / 24;
    p.fill(static_cast<std::uint8_t>(level));
  }
  return grey;
}

}  // namespace tribunal
