// Pictures of 8-bit RGB pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tracer/image/colour.h"

namespace tribunal {

using Pixel = std::array<std::uint8_t, 3>;

/// The pixels of a picture, row by row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<Pixel> pixels;

  Image(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  friend bool operator==(const Image&, const Image&) = default;
};

/// Clamps to 0..1 and rounds to the nearest of 256 levels; no gamma. Not a number becomes 0.
inline Pixel to_pixel(const Colour& c) {
  const auto level = [](double x) {
    return x > 0 ? static_cast<std::uint8_t>(std::min(x, 1.0) * 255 + 0.5) : std::uint8_t{0};
  };
  return {level(c.r), level(c.g), level(c.b)};
}

/// The picture as a PNG file's bytes; the same pixels give the same bytes.
std::string to_png(const Image& image);

/// The picture in dim grey: a background for marks.
Image dimmed(const Image& image);

}  // namespace tribunal
