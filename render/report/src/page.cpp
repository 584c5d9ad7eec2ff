// SPDX-License-Identifier: MIT
#include "occlude/render/page.h"

#include <fmt/format.h>

#include "page_files.h"

namespace occlude::render {

std::string page(const std::string& title, const std::string& body) {
  return fmt::format(
      R"(<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>{}</title><style>{}</style></head><body>
{}</body></html>
)",
      title, page_file("page.css"), body);
}

}  // namespace occlude::render
