// SPDX-License-Identifier: MIT
// The two files in which a benchmark leaves its results: NAME.json and NAME.html.
#pragma once

#include <filesystem>
#include <string>

#include "occlude/render/interrupt.h"
#include "occlude/render/output_file.h"
#include "occlude/render/output_folder.h"

namespace occlude::cli {

/// Opens both files, so that errors are reported before the work starts. Without commit() neither appears.
class ReportFiles {
 public:
  ReportFiles(const std::filesystem::path& folder, const std::string& name)
      : folder_(folder), json_(folder / (name + ".json")), html_(folder / (name + ".html")) {}

  void commit(const std::string& json, const std::string& html) {
    json_.write(json);
    html_.write(html);
    json_.close();
    html_.close();
    const render::Uninterrupted together;
    json_.commit();
    html_.commit();
  }

  /// Of the page, which is for people.
  [[nodiscard]] std::string path() const { return html_.path().string(); }

 private:
  render::OutputFolder folder_;
  render::OutputFile json_, html_;
};

}  // namespace occlude::cli
