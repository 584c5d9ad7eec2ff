// SPDX-License-Identifier: MIT
#include "occlude/render/page.h"

#include <fmt/format.h>

#include "deflated.h"
#include "occlude/render/formats.h"
#include "page_files.h"

namespace occlude::render {

std::string page(const std::string& title, const std::string& body) {
  return fmt::format(
      R"(<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>{}</title><style>{}</style></head><body>
{}</body></html>
)",
      title, page_file("page.css"), body);
}

std::string picture_html(const std::string& png, const std::string& caption) {
  return fmt::format(R"(<figure><img src="data:image/png;base64,{0}" alt="{1}"><figcaption>{1}</figcaption></figure>)",
                     base64(png), escaped(caption));
}

}  // namespace occlude::render
