// SPDX-License-Identifier: MIT
// Camera paths as tables of matrices.
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "matrix_poses.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/line_reader.h"
#include "path_readers.h"
#include "text_number.h"
#include "words.h"

namespace occlude::render {
namespace {

MatrixNumbers matrix_of(const std::vector<std::string_view>& words, const std::string& place) {
  MatrixNumbers matrix{{}, place};
  for (const std::string_view word : words) {
    const auto number = parse_number<double>(word);
    if (!number) throw InputError(place + ": expected a number");
    matrix.numbers.push_back(*number);
  }
  return matrix;
}

}  // namespace

CameraPath read_csv_path(const std::filesystem::path& file, const PathDefaults& defaults) {
  require_readable(file);
  std::vector<MatrixNumbers> matrices;
  LineReader lines(file.string());
  bool is_first = true;
  for (std::string line; lines.next(line);) {
    const std::vector<std::string_view> words = words_of(line, ",; \t\r");
    if (words.empty() || words.front().starts_with('#')) continue;
    const bool is_heading = is_first && !parse_number<double>(words.front());
    is_first = false;
    if (is_heading) continue;
    if (matrices.size() == kMostFrames)
      throw InputError(fmt::format("{}: more than {} matrices", file.string(), kMostFrames));
    matrices.push_back(matrix_of(words, fmt::format("{}:{}", lines.name(), lines.number())));
  }
  if (matrices.size() < 2) throw InputError(file.string() + ": expected at least two lines, each with a matrix");
  CameraPath path;
  path.up = defaults.up;
  path.frames = matrices.size();
  add_keyframes(path, matrices, defaults.order, "give --matrix-order row or --matrix-order column");
  if (const auto fault = fault_of(path)) throw InputError(fmt::format("{}: {}", file.string(), fault->text));
  return path;
}

}  // namespace occlude::render
