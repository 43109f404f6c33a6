// Linear RGB light.
#pragma once

namespace tribunal {

/// Linear red, green and blue, 1 = full intensity of a channel; sums may exceed 1 and are clamped on output.
struct Colour {
  double r = 0, g = 0, b = 0;

  Colour& operator+=(const Colour& c) {
    r += c.r;
    g += c.g;
    b += c.b;
    return *this;
  }
  friend Colour operator*(double k, const Colour& c) { return {k * c.r, k * c.g, k * c.b}; }
  friend Colour operator*(const Colour& p, const Colour& q) { return {p.r * q.r, p.g * q.g, p.b * q.b}; }
};

}  // namespace tribunal
