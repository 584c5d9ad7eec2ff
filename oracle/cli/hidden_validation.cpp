// SPDX-License-Identifier: MIT
#include "hidden_validation.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "hidden_claims.h"
#include "occlude/render/errors.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/packing.h"
#include "occlude/render/progress.h"

namespace occlude::cli {
namespace {

void pack(render::Packer& packer, const proof::HiddenLine& line) {
  packer.put(line.failure).put(line.is_claim);
  packer.put(line.claim.from).put(line.claim.faces).put(line.claim.is_outside).put(line.claim.may_touch);
  packer.put(line.from).put(line.polygons).put(line.inside).put(line.well_inside);
}

/// Throws PartError for what no line of this model proves.
proof::HiddenLine unpacked(render::Unpacker& unpacker, const proof::ModelPolygons& model) {
  proof::HiddenLine line;
  line.failure = unpacker.text();
  line.is_claim = unpacker.flag();
  line.claim.from = unpacker.list<kernel::Aabb>();
  line.claim.faces = unpacker.list<std::array<std::size_t, 2>>();
  line.claim.is_outside = unpacker.flag();
  line.claim.may_touch = unpacker.flag();
  line.from = unpacker.get<kernel::Aabb>();
  line.polygons = unpacker.list<std::uint32_t>();
  line.inside = unpacker.list<culler::FanTriangle>();
  line.well_inside = unpacker.list<culler::FanTriangle>();
  std::size_t end = 0;
  for (const auto& [first, count] : line.claim.faces) {
    render::require_part(end <= first && count <= model.faces() && first <= model.faces() - count,
                         "a claim about polygons that the model does not have");
    end = first + count;
  }
  const std::size_t polygons = model.hierarchy().soup().size();
  const auto is_of_model = [&](std::uint32_t p) { return p < polygons; };
  render::require_part(std::ranges::all_of(line.polygons, is_of_model), "a polygon that the model does not have");
  return line;
}

/// The outcome has an entry for each line, up to the first that cannot be read.
std::string prove_hidden(const proof::HiddenProver& prover, const std::vector<std::string>& lines) {
  std::vector<proof::HiddenLine> proved(lines.size());
  std::vector<std::string> unreadable(lines.size());
  const auto prove_one = [&](std::size_t i) {
    try {
      proved[i] = prover.prove(lines[i]);
    } catch (const cases::LineError& error) {
      unreadable[i] = error.what();
    }
  };
  culler::parallel_for(lines.size(), prove_one, render::check_interrupt);
  render::Packer packer;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    packer.put(unreadable[i]);
    if (!unreadable[i].empty()) break;
    pack(packer, proved[i]);
  }
  return packer.bytes();
}

/// Takes what is proved in the order of the file. Claims are settled where the next ones begin.
class Settling {
 public:
  Settling(const proof::ModelPolygons& model, HiddenValidation& result) : claims_(model), result_(result) {}

  void take(proof::HiddenLine line, const std::string& place) {
    if (line.is_claim) {
      if (claims_.has_proofs()) settle();
      places_.push_back(place);
    } else {
      ++result_.witnesses;
      if (!line.failure.empty()) return note(result_.line_fault, place, line.failure);
      ++result_.proved_witnesses;
    }
    claims_.add(std::move(line));
  }

  void settle() {
    const proof::HiddenClaims::Settled settled = claims_.settle(render::check_interrupt);
    result_.pairs += settled.claimed;
    result_.proved_pairs += settled.proved;
    if (const auto& open = settled.first) {
      note(result_.claim_fault, places_[open->claim],
           fmt::format("polygon {} is not proved to be hidden from all of box {}", open->face, open->box));
    }
    places_.clear();
  }

 private:
  static void note(std::string& first, const std::string& place, const std::string& what) {
    if (first.empty()) first = fmt::format("{}: {}", place, what);
  }

  proof::HiddenClaims claims_;
  std::vector<std::string> places_;  ///< of the claims
  HiddenValidation& result_;
};

}  // namespace

bool passed(const HiddenValidation& v) { return v.proved_witnesses == v.witnesses && v.proved_pairs == v.pairs; }

std::string to_text(const HiddenValidation& v) {
  return fmt::format("{} of {} witnesses proved\n{} of {} hidden pairs of eyes and polygon proved\n", v.proved_witnesses,
                     v.witnesses, v.proved_pairs, v.pairs);
}

std::string to_json(const HiddenValidation& v) {
  const nlohmann::ordered_json told{{"witnesses", v.witnesses},
                                    {"proved", v.proved_witnesses},
                                    {"failed", v.witnesses - v.proved_witnesses},
                                    {"pairs", v.pairs},
                                    {"proved_pairs", v.proved_pairs}};
  return told.dump(2) + "\n";
}

HiddenValidation validate_hidden(render::Job& job, const culler::Hierarchy& hierarchy, WitnessFile& file) {
  const proof::HiddenProver prover(hierarchy);
  HiddenValidation result;
  Settling settling(prover.polygons(), result);
  render::Progress progress("proved MB", file.size() >> 20U);
  std::deque<std::vector<std::string>> asked;  // the places of the lines of each part that is not taken yet
  const auto next = [&]() -> std::optional<std::string> {
    const std::vector<Place> places = next_part([&] { return file.next(); });
    if (places.empty()) return std::nullopt;
    asked.emplace_back();
    for (const Place& place : places) asked.back().push_back(place.name);
    return pack_lines(places);
  };
  const auto take = [&](const std::string& bytes) {
    render::Unpacker unpacker(bytes);
    for (const std::string& place : asked.front()) {
      if (const std::string fault = unpacker.text(); !fault.empty()) {
        unpacker.finish();
        throw render::InputError(fmt::format("{}: {}", place, fault));
      }
      settling.take(unpacked(unpacker, prover.polygons()), place);
    }
    unpacker.finish();
    asked.pop_front();
    progress.update(file.read() >> 20U);
  };
  job.run({next, [&](const std::string& part) { return prove_hidden(prover, unpack_lines(part)); }, take});
  settling.settle();
  return result;
}

}  // namespace occlude::cli
