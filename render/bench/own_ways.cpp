// SPDX-License-Identifier: MIT
#include "own_ways.h"

#include <optional>

#include "occlude/culler/culler.h"
#include "occlude/render/view_along_path.h"

namespace occlude::experiments {
namespace {

class OwnWay : public VisibilityWay {
 public:
  OwnWay(const Subject& subject, const render::WalkOptions& walk)
      : subject_(subject), walk_(walk), culler_(make_culler(subject.soup, walk)) {}

  void restart() override { along_.emplace(culler_, subject_.path, walk_, walk_.cull); }
  void move_to(std::size_t frame) override { view_ = &along_->before(frame); }
  void cull(const culler::Camera& camera) override { culler_.cull(camera, walk_.cull, *view_); }
  [[nodiscard]] std::vector<culler::PolygonRange> drawn() const override { return view_->result().drawn; }

 private:
  const Subject& subject_;
  render::WalkOptions walk_;
  culler::Culler culler_;
  std::optional<render::ViewAlongPath> along_;
  culler::View* view_ = nullptr;
};

}  // namespace

std::vector<UnpreparedWay> own_ways(const Subject& subject, const render::WalkOptions& walk) {
  const auto way = [&](const char* name, culler::Method method, std::size_t occluders) {
    render::WalkOptions options = walk;
    options.cull.method = method;
    options.cull.occluders = occluders;
    return UnpreparedWay{kOurs, name, [&subject, options] { return std::make_unique<OwnWay>(subject, options); }};
  };
  return {way(kViewFrustumAlone, culler::Method::frusta, 0), way(kByFrusta, culler::Method::frusta, walk.cull.occluders),
          way(kByCover, culler::Method::cover, walk.cull.occluders)};
}

}  // namespace occlude::experiments
