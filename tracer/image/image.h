// Pictures of 8-bit RGB pixels.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tracer/colour.h"

namespace tribunal {

using Pixel = std::array<std::uint8_t, 3>;

/// Rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<Pixel> pixels;

  Image(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  friend bool operator==(const Image&, const Image&) = default;
};

/// Clamps to 0..1 and rounds to the nearest of 256 levels; no gamma. Not a number becomes 0.
Pixel to_pixel(const Colour& c);

/// The picture as a PNG file's bytes; the same pixels give the same bytes.
std::string to_png(const Image& image);

/// The picture in dim grey: a background for marks.
Image dimmed(const Image& image);

}  // namespace tribunal
