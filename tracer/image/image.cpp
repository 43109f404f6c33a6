#include "tracer/image/image.h"

#include <algorithm>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

#include "exact/base/failure.h"

namespace tribunal {
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
