// SPDX-License-Identifier: MIT
#include "kept_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/output_file.h"

namespace occlude::render {
namespace fs = std::filesystem;
namespace {

/// Of the file "job", which has one line.
constexpr std::uint64_t kMostJob = std::uint64_t{1} << 20U;
/// Of a part: in the lists of 256 parts of a preprocess are 2^30 numbers at the most, 16 MiB a part; in a part of a
/// validation the polygons that show in four frames, 25 MB for 50 million of them. Lists may be of very different lengths.
constexpr std::uint64_t kMostPart = std::uint64_t{256} << 20U;

std::string hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

/// The file "job".
std::string job_line(std::uint64_t key, const Seal& seal) {
  return "occlude parts " + hex(key) + " " + seal.of({hex(key)}) + "\n";
}

/// Also what a killed process left of a file that it was writing.
bool is_ours(const std::string& name) {
  return name == "job" || name.starts_with("part-") || name.starts_with(".occlude.tmp-");
}

/// Whether there is anything of this name. What cannot be read says so when it is read.
bool is_there(const fs::path& file) {
  std::error_code error;
  return fs::exists(fs::symlink_status(file, error));
}

std::vector<fs::path> files_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (is_ours(entry.path().filename().native())) files.push_back(entry.path());
  }
  return files;
}

void write(const fs::path& file, std::string_view head, std::string_view rest = {}) {
  OutputFile out(file);
  out.write(head);
  out.write(rest);
  out.commit();
}

}  // namespace

KeptParts::KeptParts(fs::path folder, std::uint64_t key, bool resume) : folder_(std::move(folder)), key_(key) {
  const fs::path job = folder_ / "job";
  const std::string name = folder_.string();
  const bool has_job = is_there(job);
  if (has_job && !resume) {
    throw InputError(name + ": has finished parts of an earlier run; go on with --resume, or remove the folder");
  }
  if (!has_job && resume) throw InputError(name + ": has no parts of an earlier run, so --resume cannot go on");
  if (has_job) {
    if (read_input(job, kMostJob) != job_line(key, seal_)) {
      throw InputError(name + ": has parts of another run: another user, other options, input or program");
    }
    return;
  }
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw InputError(fmt::format("{}: cannot create the folder: {}", name, error.message()));
  write(job, job_line(key, seal_));
}

KeptParts::~KeptParts() {
  if (count() == 0) remove();
}

std::size_t KeptParts::count() const {
  const auto is_part = [](const fs::path& file) { return file.filename().native().starts_with("part-"); };
  return static_cast<std::size_t>(std::ranges::count_if(files_of(folder_), is_part));
}

std::optional<std::string> KeptParts::find(PartNumber number, const std::string& input) const {
  const fs::path file = file_of(number);
  if (!is_there(file)) return std::nullopt;
  std::string bytes = read_input(file, kMostPart);
  if (!bytes.starts_with(seal_.of({input}) + " ")) return std::nullopt;
  const std::string_view result = std::string_view(bytes).substr(std::min(bytes.find('\n'), bytes.size() - 1) + 1);
  const std::size_t head = bytes.size() - result.size();
  if (bytes.compare(0, head, head_of(number, input, result)) != 0) {
    throw InputError(file.string() + ": not as a run of yours has kept it; remove it, and --resume makes it again");
  }
  bytes.erase(0, head);
  return bytes;
}

void KeptParts::keep(PartNumber number, const std::string& input, const std::string& result) {
  const std::string head = head_of(number, input, result);
  if (head.size() + result.size() > kMostPart) return;  // it would not be read
  write(file_of(number), head, result);
}

void KeptParts::remove() {
  std::error_code error;  // what cannot be removed stays
  for (const fs::path& file : files_of(folder_)) fs::remove(file, error);
  fs::remove(folder_, error);
}

std::string KeptParts::head_of(PartNumber number, const std::string& input, std::string_view result) const {
  const std::string input_seal = seal_.of({input});
  return input_seal + " " + seal_.of({hex(key_), file_of(number).filename().string(), input_seal, result}) + "\n";
}

fs::path KeptParts::file_of(PartNumber number) const {
  return folder_ / fmt::format("part-{}-{:06}", number.stage, number.part);
}

}  // namespace occlude::render
