// The demo's page: one static HTML file with relative links and nothing from elsewhere.
#pragma once

#include <string>

#include "exact/report/tour.h"

namespace tribunal {

/// Paths of the pictures and charts that the page links to, relative to the demo's directory.
namespace demo_files {
inline constexpr const char* fuzz = "fuzz";
inline constexpr const char* counterexample = "counterexample.jsonl";
inline constexpr const char* charts = "charts";
}  // namespace demo_files

/// "certificate-NAME".
std::string certificate_directory(const std::string& method);

/// "render/exact-NAME.png": the reference's picture of the world in which it is compared with the method.
std::string exact_picture(const std::string& method);

/// "render/NAME.png".
std::string own_picture(const std::string& method);

/// "render/exact-NAME.diff.png".
std::string difference_picture(const std::string& method);

/// The top left corner of the `width` × `height` window with the most places in it, inside the picture.
Place busiest_window(const PictureFigures& picture, int width, int height);

std::string page(const Tour& tour);

}  // namespace tribunal
