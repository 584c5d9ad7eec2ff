// SPDX-License-Identifier: MIT
// A model to the last bit, as bytes that compress well: what the culler in a page is made of.
#pragma once

#include <string>
#include <string_view>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {

/// packed_soup.cpp has the format.
[[nodiscard]] std::string packed(culler::SoupView soup);

/// The same soup, vertex by vertex. Throws std::invalid_argument for bytes that are not of a soup.
[[nodiscard]] culler::PolygonSoup unpacked(std::string_view bytes);

}  // namespace occlude::render
