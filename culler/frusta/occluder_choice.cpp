// SPDX-License-Identifier: MIT
#include "frusta/occluder_choice.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "base/each_bit.h"
#include "camera/shadow_rule.h"
#include "frusta/seen_occluders.h"
#include "frusta/solid_angle.h"
#include "model/bounds.h"

namespace occlude::culler {
namespace {

/// A score is the product of at most three such powers. The limit keeps it finite, so that it can be sorted whatever the
/// weights.
constexpr double kMostPower = 1e100;

double weighted(double criterion, double weight) {
  if (weight == 0) return 1;
  return weight == 1 ? criterion : std::fmin(std::pow(criterion, weight), kMostPower);  // NaN becomes that too
}

/// Frusta are reused by other occluders, and would grow again and again until each of them has been the largest. Nearly all
/// have at most this many planes, those of the profile included.
constexpr std::size_t kPlanes = 64;

/// A polygon may be a part of a joined region, and the region of a shell, so each candidate may lead to this many tries.
constexpr std::size_t kTries = 3;

/// Probes are chosen from at most this many candidates that were not tried lately.
constexpr std::size_t kPool = 64;
/// Occluders are near each other within the angle that has this cosine. The best of all occluders raises the score of what
/// is near it by this factor. Of the factors 0, 3 and 10 and the cosines 0.95 and 0.8, these two cull most on the paths
/// through the city, Utrecht, the castle and Sponza together.
constexpr double kNear = 0.8, kNeighbour = 10;

/// A list is scored in parts of at least so many occluders: a short one is not worth waking a thread. A thread that comes
/// late finds that others have done most of its parts.
constexpr std::size_t kLeastOfPart = 1024, kPartsOfThread = 4;

/// The shadows of so many probes are worth waking a thread: each takes a microsecond or two.
constexpr std::size_t kLeastMade = 4;

/// In how many groups so many occluders are.
constexpr std::size_t groups_of(std::size_t occluders) {
  return (occluders + SeenOccluders::kMost - 1) / SeenOccluders::kMost;
}

/// Calls take(candidate) for candidates, best first, until it returns false. Few are taken, so they are not all sorted.
template <class Take>
void for_best_first(std::vector<Candidate>& candidates, const Take& take) {
  const auto is_worse = [](const Candidate& a, const Candidate& b) { return b < a; };
  std::make_heap(candidates.begin(), candidates.end(), is_worse);
  for (auto end = candidates.end(); end != candidates.begin() && take(candidates.front()); --end) {
    std::pop_heap(candidates.begin(), end, is_worse);
  }
}

/// Whether the silhouettes share two corners. Nothing shows between occluders that share an edge.
bool share_an_edge(const kernel::ShadowFrustum& a, const kernel::ShadowFrustum& b) {
  return std::ranges::count_if(a.silhouette(), [&](const kernel::Vec3& v) {
           return std::ranges::find(b.silhouette(), v) != b.silhouette().end();
         }) >= 2;
}

}  // namespace

OccluderChoice::OccluderChoice(const OccluderSet& occluders, const CullOptions& options, Frame& frame, FrustaMemory& memory)
    : occluders_(occluders),
      view_(frame.view),
      options_(options),
      frame_(frame.result),
      memory_(memory),
      work_(kChoiceWorkOfEach * options.occluders) {
  const std::size_t all = occluders.size(), used = std::min(all, options.occluders + options.probes);
  const std::size_t remembered = std::min(all, (OccluderHistory::kFrames + 1) * used);  // with those about to be forgotten
  memory.history.reserve(all, remembered);
  const std::size_t candidates = std::max({occluders.lists().longest(), remembered, kPool});
  memory.listed.groups.reserve(groups_of(occluders.lists().longest()));
  memory.order.reserve(candidates, all);
  memory.candidates.reserve(candidates);
  // A list in fewer parts than the longest has fewer than 2 * kLeastOfPart in each, up to whole groups.
  if (!is_alone()) {
    const std::size_t longest = occluders.lists().longest(), parts = parts_of(longest);
    memory.runner.reserve(std::max(parts + 1, kPool));
    if (memory.choice_slices.size() < parts) memory.choice_slices.resize(parts);
    for (ChoiceSlice& part : memory.choice_slices) {
      part.candidates.reserve(std::max(2 * kLeastOfPart, longest / parts + 1) + 2 * SeenOccluders::kMost);
    }
  }
  frame.result.occluders.reserve(std::min(all, options.occluders));
  memory.probes.reserve(std::min(all, options.probes));
  while (memory.unmade.size() < std::min({all, options.probes, kPool})) {
    memory.unmade.emplace_back().loop.reserve(ConvexRegions::kMostSides);
  }
  memory.directions.reserve(std::min(all, options.occluders));
  memory.tried.reserve(std::min(all, kTries * candidates));
  memory.loop.reserve(ConvexRegions::kMostSides);
  while (memory.spare.size() < used) memory.spare.emplace_back().reserve(kPlanes);
  while (memory.shrunk.size() < std::min(all, options.occluders)) memory.shrunk.emplace_back().reserve(kPlanes);
  const ConvexShells& shells = occluders.shells();
  memory.silhouettes.reserve(std::min(shells.size(), OccluderHistory::kFrames * used), shells.size(), shells.most_faces(),
                             shells.most_edges());
  memory.trials.grow(occluders.size());
  for (const std::uint32_t i : memory.tried) memory.trials[i] = Trial::none;
  memory.tried.clear();
}

OccluderChoice::~OccluderChoice() {
  CullStats& stats = frame_.stats;
  if (stats.occluders_in_view > 0) stats.sort_comparisons = memory_.order.comparisons();
  stats.choice_work = work_.taken();
}

void OccluderChoice::sort_candidates_and_take_proven() {
  const OccluderLists& lists = occluders_.lists();
  const std::size_t region = lists.partition().region_at(view_.eye);
  const OccluderLists::List listed = lists.list(region);
  frame_.stats.potential_occluders = listed.occluders.size();
  is_list_gathered_ = memory_.listed.region == region;
  memory_.listed.region.reset();  // until all of it is there: a thread of the caller may throw
  memory_.listed.groups.resize(groups_of(listed.occluders.size()));
  begin(listed);
  memory_.listed.region = region;
}

void OccluderChoice::begin(const OccluderLists::List& listed) {
  if (!is_alone()) return begin_on_threads(listed);
  memory_.candidates.clear();
  find_candidates(listed, 0, memory_.listed.groups.size(), memory_.candidates);
  sort(memory_.candidates);
  take_proven();
}

/// The first part takes what is proven, the others find candidates, in the order of the list. One that has the whole list
/// sorts them, too.
void OccluderChoice::begin_on_threads(const OccluderLists::List& listed) {
  const std::size_t groups = memory_.listed.groups.size(), parts = parts_of(listed.occluders.size());
  const std::span<ChoiceSlice> of_list = std::span(memory_.choice_slices).first(parts);
  for (std::size_t i = 0; i < parts; ++i) {
    of_list[i].first = groups * i / parts;
    of_list[i].end = groups * (i + 1) / parts;
  }
  const auto work_of = [&](std::size_t i) {
    return i == 0 ? kLeastOfPart : (of_list[i - 1].end - of_list[i - 1].first) * SeenOccluders::kMost;
  };
  memory_.runner.run(*options_.executor, parts + 1, work_of, [&](std::size_t i) {
    if (i == 0) return take_proven();
    ChoiceSlice& part = of_list[i - 1];
    part.candidates.clear();
    find_candidates(listed, part.first, part.end, part.candidates);
    if (parts == 1) sort(part.candidates);
  });
  if (parts == 1) return;
  memory_.candidates.clear();
  for (const ChoiceSlice& part : of_list) {
    memory_.candidates.insert(memory_.candidates.end(), part.candidates.begin(), part.candidates.end());
  }
  sort(memory_.candidates);
}

void OccluderChoice::sort(std::span<const Candidate> candidates) {
  memory_.order.update(candidates, occluders_.size());
  CullStats& stats = frame_.stats;
  stats.occluders_in_view = candidates.size();
  stats.sort_kept = memory_.order.kept();
  stats.sort_moves = memory_.order.moves();
}

/// Finds the candidates of the groups from `first` to before `end`, which it gathers unless they are there.
void OccluderChoice::find_candidates(const OccluderLists::List& listed, std::size_t first, std::size_t end,
                                     std::vector<Candidate>& found) const {
  const Objective& objective = options_.objective;
  for (std::size_t group = first; group < end; ++group) {
    SeenOccluders& seen = memory_.listed.groups[group];
    const std::size_t before = group * SeenOccluders::kMost;
    const auto occluder_at = [&](std::size_t k) { return listed.occluders[before + k]; };
    if (!is_list_gathered_) {
      seen.assign(occluders_, std::min(SeenOccluders::kMost, listed.occluders.size() - before), occluder_at);
    }
    for_each_in_view(seen, occluder_at, [&](std::size_t k, double size) {
      double score = weighted(size, objective.solid_angle);
      if (!listed.hidden.empty()) score *= weighted(1 + double{listed.hidden[before + k]}, objective.depth_complexity);
      found.push_back({score, occluder_at(k)});
    });
  }
}

/// In how many parts a list of so many is scored.
std::size_t OccluderChoice::parts_of(std::size_t listed) const {
  if (is_alone()) return 1;
  return std::clamp<std::size_t>(listed / kLeastOfPart, 1, kPartsOfThread * options_.executor->threads());
}
bool OccluderChoice::is_alone() const { return options_.executor == nullptr || options_.executor->threads() == 1; }

/// Calls visit(k, size) for each of these occluders that is in view, with how large it looks. occluder_at(k) is its number.
template <class OccluderAt, class Visit>
void OccluderChoice::for_each_in_view(SeenOccluders& seen, const OccluderAt& occluder_at, const Visit& visit) const {
  const Objective::Angle angle = options_.objective.angle;
  const bool is_area_angle = view_.is_perspective && angle == Objective::Angle::area;
  seen.see(view_.eye, frame_.view);
  for_each_bit(seen.in_view, [&](std::uint32_t k) {
    visit(k, is_area_angle ? seen.angle[k] : seen_size(occluders_, occluder_at(k), view_, angle));
  });
}

void OccluderChoice::take_proven() {
  const Objective& objective = options_.objective;
  if (objective.coherence == 0) return;
  std::vector<Candidate>& proven = memory_.candidates;
  proven.clear();
  for (const auto& [occluder, frame, hidden] : memory_.history.recent()) {
    if (hidden > 0) proven.push_back({weighted(hidden, objective.coherence), occluder});
  }
  std::size_t in_view = 0;
  for (std::size_t first = 0; first < proven.size(); first += SeenOccluders::kMost) {
    const auto occluder_at = [&](std::size_t k) { return proven[first + k].occluder; };
    SeenOccluders seen;
    seen.assign(occluders_, std::min(SeenOccluders::kMost, proven.size() - first), occluder_at);
    for_each_in_view(seen, occluder_at, [&](std::size_t k, double size) {
      proven[in_view++] = {weighted(size, objective.solid_angle) * proven[first + k].score, occluder_at(k)};
    });
  }
  proven.resize(in_view);
  for_best_first(proven, [&](const Candidate& c) {
    if (is_full()) return false;
    static_cast<void>(take(c.occluder));
    return true;
  });
}

void OccluderChoice::take_untried() {
  memory_.order.for_best_first([&](const Candidate& c) {
    if (is_full()) return false;
    if (!memory_.history.hidden(c.occluder)) static_cast<void>(take(c.occluder));
    return true;
  });
}

void OccluderChoice::take_best() {
  memory_.order.for_best_first([&](const Candidate& c) {
    if (is_full()) return false;
    static_cast<void>(take(c.occluder));
    return true;
  });
}

void OccluderChoice::take_probes() {
  std::vector<Candidate>& pool = memory_.candidates;
  pool.clear();
  note_directions();
  memory_.order.for_best_first([&](const Candidate& c) {
    if (pool.size() == kPool) return false;
    if (memory_.history.hidden(c.occluder)) return true;
    const double good = 1 + kNeighbour * goodness_near(direction_to(occluders_[c.occluder].centre));
    pool.push_back({c.score * weighted(good, options_.objective.coherence), c.occluder});
    return true;
  });
  are_probes_ = true;
  do {
    for_best_first(pool, [&](const Candidate& c) {
      if (memory_.probes.size() >= options_.probes || !work_.is_left()) return false;
      static_cast<void>(take(c.occluder));
      return true;
    });
  } while (!make_probes());
}

void OccluderChoice::note_directions() {
  const auto hidden = [&](const Occluder& o) -> double { return memory_.history.hidden(o.index).value_or(0); };
  double most = 1;
  for (const Occluder& o : frame_.occluders) most = std::max(most, hidden(o));
  memory_.directions.clear();
  for (const Occluder& o : frame_.occluders) {
    memory_.directions.push_back({direction_to(occluders_[o.index].centre), hidden(o) / most});
  }
}

/// The goodness of the best of this frame's occluders that are near this direction in the picture; 0 if none is. REQUIRES:
/// note_directions() was called.
double OccluderChoice::goodness_near(const glm::dvec3& direction) const {
  double best = 0;
  for (const OccluderDirection& o : memory_.directions) {
    const int is_near = glm::dot(direction, o.direction) > kNear ? 1 : 0;
    best = std::max(best, is_near * o.goodness);  // without a branch
  }
  return best;
}

/// The direction from the eye to a point.
glm::dvec3 OccluderChoice::direction_to(const glm::dvec3& point) const {
  const glm::dvec3 v = point - view_.eye;
  const double length = glm::length(v);
  return length > 0 ? v / length : view_.axes.forward;
}

bool OccluderChoice::is_full() const { return frame_.occluders.size() >= options_.occluders || !work_.is_left(); }

/// Takes the occluder, or a larger one that it is a part of, as an occluder of the frame or as a probe. Returns whether one
/// of them is taken. A part is used only where its whole cannot be.
bool OccluderChoice::take(std::uint32_t i) {
  const std::uint32_t container = occluders_.container(i);
  if (container != i && take(container)) return true;
  Trial& trial = memory_.trials[i];
  if (trial == Trial::none) memory_.tried.push_back(i);
  if (trial == Trial::none || trial == Trial::again) {
    trial = is_usable(i) && add(i) ? Trial::taken : Trial::refused;
  }
  return trial == Trial::taken;
}

bool OccluderChoice::is_usable(std::uint32_t i) {
  if (!work_.is_left()) return false;
  occluders_.vertices(i, memory_.loop);
  work_.take(memory_.loop.size());
  return !view_.may_clip(memory_.loop) && !is_in_shadow();
}

bool OccluderChoice::is_in_shadow() {
  kernel::Aabb box = empty_box();
  for (const kernel::Vec3& v : memory_.loop) grow(box, v);
  return std::ranges::any_of(frame_.occluders, [&](const Occluder& o) {
    const kernel::Decision found = decide_open(o.frustum, box, Asked{});
    work_.take(o.frustum, found.stage);
    return found.relation == kernel::Relation::inside;
  });
}

bool OccluderChoice::add(std::uint32_t i) {
  const bool is_shell = occluders_.is_shell(i);
  if (are_probes_ && !is_shell) {
    put_off(i);
    return true;
  }
  std::vector<kernel::ShadowFrustum>& spare = memory_.spare;
  const kernel::Refusal refusal =
      is_shell ? add_shell(i, spare.back()) : spare.back().assign(view_.viewpoint, memory_.loop, options_.shadow_near);
  if (refusal != kernel::Refusal::none) {
    work_.take(PlaneWork::kExact);  // the kernel refuses where signs are zero, which takes the exact stage
    return false;
  }
  if (options_.test == kernel::Test::overlap && !are_probes_) spare.back().prepare_overlap();
  (are_probes_ ? memory_.probes : frame_.occluders).push_back({i, std::move(spare.back()), 0});
  spare.pop_back();
  return true;
}

/// Leaves the shadow of a probe to make_probes(). That of a shell is made at once, because silhouettes share memory.
void OccluderChoice::put_off(std::uint32_t i) {
  UnmadeProbe& unmade = memory_.unmade[unmade_++];
  unmade.probe = memory_.probes.size();
  unmade.loop.swap(memory_.loop);
  memory_.probes.push_back({i, std::move(memory_.spare.back()), 0});
  memory_.spare.pop_back();
}

/// Makes the shadows that were put off. Returns false if probes are to be tried again.
bool OccluderChoice::make_probes() {
  const std::span<UnmadeProbe> all = std::span(memory_.unmade).first(unmade_);
  if (is_alone() || all.size() < kLeastMade) {
    for (UnmadeProbe& unmade : all) make(unmade);
  } else {
    const auto work_of = [&](std::size_t i) { return all[i].loop.size(); };
    memory_.runner.run(*options_.executor, all.size(), work_of, [&](std::size_t i) { make(all[i]); });
  }
  return keep_made();
}

void OccluderChoice::make(UnmadeProbe& unmade) {
  unmade.refusal = memory_.probes[unmade.probe].frustum.assign(view_.viewpoint, unmade.loop, options_.shadow_near);
}

/// Keeps the probes before the first that the kernel refuses. Those after it are tried again, because its parts come before
/// them. So while work is left, the probes are those that shadows made one after another would give.
bool OccluderChoice::keep_made() {
  const auto all = std::span(memory_.unmade).first(std::exchange(unmade_, 0));
  std::size_t kept = memory_.probes.size();
  for (std::size_t i = all.size(); i > 0; --i) {
    if (all[i - 1].refusal == kernel::Refusal::none) continue;
    kept = all[i - 1].probe;
    work_.take(PlaneWork::kExact);
    memory_.trials[memory_.probes[kept].index] = Trial::refused;
  }
  const bool are_all = kept == memory_.probes.size();
  while (memory_.probes.size() > kept) {
    Trial& trial = memory_.trials[memory_.probes.back().index];
    if (trial == Trial::taken) trial = Trial::again;
    memory_.spare.push_back(std::move(memory_.probes.back().frustum));
    memory_.probes.pop_back();
  }
  return are_all;
}

kernel::Refusal OccluderChoice::add_shell(std::uint32_t i, kernel::ShadowFrustum& frustum) {
  const kernel::ConvexPolytope& polytope = occluders_.polytope(i);
  kernel::PolytopeSilhouette& seen = memory_.silhouettes.of(static_cast<std::uint32_t>(i - occluders_.regions().size()));
  const kernel::Refusal refusal = frustum.assign(view_.viewpoint, polytope, options_.shadow_near, seen);
  frame_.stats.silhouette_faces += polytope.faces().size();
  frame_.stats.silhouette_faces_asked += seen.faces_asked();
  return refusal;
}

void OccluderChoice::pair_neighbours() {
  const std::span<const Occluder> occluders = frame_.occluders;
  std::vector<ShadowPair>& pairs = frame_.pairs;
  pairs.reserve(ShadowPair::kMostOfEach * options_.occluders);
  const std::size_t most = ShadowPair::kMostOfEach * occluders.size();
  for (std::uint32_t second = 1; second < occluders.size(); ++second) {
    for (std::uint32_t first = 0; first < second; ++first) {
      if (!share_an_edge(occluders[first].frustum, occluders[second].frustum)) continue;
      pairs.push_back({first, second});
      if (pairs.size() == most) return;
    }
  }
}

}  // namespace occlude::culler
