// SPDX-License-Identifier: MIT
#include "cover/cover_buffer.h"

#include <algorithm>
#include <cmath>

#include "base/rounded_float.h"
#include "camera/single_precision.h"

namespace occlude::culler {
namespace {

/// The border around the camera's picture, as a share of the shorter side of both. Boxes that reach beyond the camera's
/// picture can be hidden only as far as the border reaches. In a picture of 576x360 this share draws as many polygons of
/// Utrecht, the castle and Sponza as 16 pixels in one of 512x288, in the same time, and 7 % fewer of a town. Where boxes are
/// large it hides more: two fifths of a globe instead of a quarter.
constexpr double kBorder = 1.0 / 6;

/// Memory is reserved for so many meshes that bring pixels of a tile nearer, on average. Frames of the models tried have
/// at most a quarter of that; one that has more allocates.
constexpr std::size_t kClosingsOfTile = 16;

}  // namespace

void CoverBuffer::begin(const FrameView& view, int width, int height, double margin) {
  const double border = kBorder * std::min(width, height);
  picture_ = ConservativeViewport(view, {width, height, border}, margin > 0 ? kSinglePrecision * view.depth : 0);
  rasteriser_.begin(picture_);
  tiles_across_ = width / kTile;
  // With a margin that is negative or not a number, nothing is hidden. Pixels need not be square.
  const double up = margin >= 0 ? margin * (height - 2 * border) : std::numeric_limits<double>::infinity();
  boxes_ = BoxPicture(picture_, {up * (picture_.scale().x / picture_.scale().y), up}, FocusLayers(picture_));
  const double share = 1 / (height - 2 * border);
  share_of_pixel_ = {share * (picture_.scale().y / picture_.scale().x), share};
  work_ = 0;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const FocusLayers& layers = boxes_.layers;
  const std::size_t tiles = pixels / kTilePixels;
  nearness_.resize(layers.count * pixels);
  farthest_.resize(layers.count * tiles + kTile);
  for (std::size_t layer = 0; layer < layers.count; ++layer) {
    std::fill_n(nearness_.data() + layer * pixels, pixels, layers.start(layer));
    std::fill_n(farthest_.data() + layer * tiles, tiles, layers.start(layer));
  }
  std::fill_n(farthest_.data() + layers.count * tiles, kTile, kOpen);
  owners_.clear();
  closings_.clear();
  keeps_closings_ = false;
  nearest_.clear();
  if (!is_of_region()) return;
  nearest_ = farthest_;
  has_changed_.assign(nearest_.size(), 0);
  erosion_.begin(picture_, layers);
}

void CoverBuffer::keep_owners() {
  owners_.assign(nearness_.size(), kNone);
  owned_ = nearness_;
  sheets_.clear();
}

void CoverBuffer::keep_closings() {
  keeps_closings_ = true;
  closings_.reserve(kClosingsOfTile * farthest_.size());
}

void CoverBuffer::add(const CoverMesh& mesh, std::uint32_t id) {
  rasteriser_.project(mesh);
  if (!is_of_region()) return add_layer(id);
  for (std::size_t layer = first_layer_of_mesh(); layer < boxes_.layers.count; ++layer) {
    if (!(rasteriser_.nearest_of_mesh() > boxes_.layers.start(layer))) continue;
    first_tile_ = layer * static_cast<std::size_t>(boxes_.tiles_of_layer);
    rasteriser_.focus(boxes_.layers.focus[layer]);
    add_layer(id);
  }
  first_tile_ = 0;
}

/// The farthest layer that the mesh is drawn into. Farther ones have to wait for join_layers(), which knows moves only
/// across and up, and loses less than the time that drawing takes is worth.
std::size_t CoverBuffer::first_layer_of_mesh() const {
  const FocusLayers& layers = boxes_.layers;
  std::size_t layer = 0;
  while (layer + layers.beyond < layers.count && layers.focus[layer + layers.beyond] < rasteriser_.farthest_of_mesh())
    ++layer;
  return layer;
}

/// From near to far, so that a layer takes over what the next one has taken over.
void CoverBuffer::join_layers() {
  const auto tiles = static_cast<std::size_t>(boxes_.tiles_of_layer);
  for (std::size_t layer = boxes_.layers.count - 1; layer-- > 0;) {
    const std::size_t first = layer * tiles;
    erosion_.erode(layer, boxes_.layers.start(layer + 1),
                   {&nearness_[first * kTilePixels], &nearest_[first], &farthest_[first], &has_changed_[first]});
  }
}

/// Into the layer that begins with first_tile_.
void CoverBuffer::add_layer(std::uint32_t id) {
  for (std::size_t sheet = 0; sheet < rasteriser_.sheets() && !is_spent(); ++sheet) {
    if (!rasteriser_.find(sheet)) continue;
    const PixelRectangle& r = rasteriser_.tiles();
    work_ += static_cast<std::size_t>(r.x1 - r.x0) * static_cast<std::size_t>(r.y1 - r.y0);
    if (const auto tiles = tiles_nearer(r, [&](std::size_t) { return rasteriser_.nearest(); })) add_sheet(*tiles, id);
  }
}

void CoverBuffer::add_sheet(const PixelRectangle& tiles, std::uint32_t id) {
  rasteriser_.rasterise_depth(tiles);
  work_ += rasteriser_.work();
  const auto left = tiles_nearer(tiles, [&](std::size_t tile) { return rasteriser_.nearness() + (tile - first_tile_); });
  if (!left) return;
  rasteriser_.draw(*left);
  if (!owners_.empty() && is_of_region()) {
    const std::span<const std::uint32_t> sheet = rasteriser_.sheet();
    sheets_.push_back({id, {sheet.begin(), sheet.end()}});
    id = static_cast<std::uint32_t>(sheets_.size() - 1);
  }
  const auto across = static_cast<std::size_t>(left->x1 - left->x0);
  for (int y = left->y0; y < left->y1; ++y) {
    const std::size_t first = tile_at(left->x0, y);
    if (!owners_.empty()) own(first, across, id);
    if (keeps_closings_) note_closings(first, across, id);
    const std::size_t in_layer = first - first_tile_;
    if (is_of_region()) note_nearest(first, across);
    bring_nearer(&nearness_[first * kTilePixels], std::span(farthest_).subspan(first, across),
                 rasteriser_.closed() + in_layer, rasteriser_.nearness() + in_layer);
  }
}

/// The smallest rectangle that holds all tiles of `r` in which something may bring a pixel nearer; none if there are no such
/// tiles. nearness_from(tile) is how near it is from this tile on, as nearer() takes it.
template <class NearnessFrom>
std::optional<PixelRectangle> CoverBuffer::tiles_nearer(const PixelRectangle& r, const NearnessFrom& nearness_from) const {
  PixelRectangle left{r.x1, r.y1, r.x0, r.y0};
  for (int y = r.y0; y < r.y1; ++y) {
    const std::size_t first = tile_at(r.x0, y);
    const auto row = std::span(farthest_).subspan(first, static_cast<std::size_t>(r.x1 - r.x0));
    const TileRange range = nearer(row, nearness_from(first));
    if (range.first >= range.end) continue;
    left = {std::min(left.x0, r.x0 + range.first), std::min(left.y0, y), std::max(left.x1, r.x0 + range.end), y + 1};
  }
  if (left.x0 >= left.x1) return std::nullopt;
  return left;
}

/// Notes how near the piece will bring pixels of tiles that lie side by side, and that it does.
void CoverBuffer::note_nearest(std::size_t first, std::size_t count) {
  for (std::size_t tile = first; tile < first + count; ++tile) {
    const float nearness = rasteriser_.nearness()[tile - first_tile_];
    const bool is_there = rasteriser_.closed()[tile - first_tile_] != 0 && nearness < std::numeric_limits<float>::infinity();
    if (!is_there) continue;
    nearest_[tile] = std::max(nearest_[tile], nearness);
    has_changed_[tile] = 1;
  }
}

/// Notes which pixels of tiles that lie side by side the piece will bring nearer.
void CoverBuffer::own(std::size_t first, std::size_t count, std::uint32_t id) {
  for (std::size_t tile = first; tile < first + count; ++tile) {
    const float nearness = rasteriser_.nearness()[tile - first_tile_];
    if (nearness == std::numeric_limits<float>::infinity()) continue;  // it is not there
    for (std::size_t i = 0; i < kTilePixels; ++i) {
      const std::size_t pixel = tile * kTilePixels + i;
      if ((rasteriser_.closed()[tile - first_tile_] >> i & 1U) == 0 || nearness <= owned_[pixel]) continue;
      owners_[pixel] = id;
      owned_[pixel] = nearness;
    }
  }
}

void CoverBuffer::note_closings(std::size_t first, std::size_t count, std::uint32_t id) {
  for (std::size_t tile = first; tile < first + count; ++tile) {
    const std::uint64_t closed = rasteriser_.closed()[tile];
    const float nearness = rasteriser_.nearness()[tile];
    if (closed == 0 || nearness == std::numeric_limits<float>::infinity()) continue;  // it is not there
    const float farther = std::nextafter(nearness, kOpen);
    const std::uint64_t pixels = closed & pixels_up_to(&nearness_[tile * kTilePixels], farther);
    if (pixels != 0) closings_.push_back({static_cast<std::uint32_t>(tile), id, pixels});
  }
}

ProjectedBoxes CoverBuffer::seen(const kernel::Aabb& box) const {
  ProjectedBoxes boxes;
  boxes.add(boxes_, box);
  boxes.project(boxes_);
  return boxes;
}

CoverBuffer::Footprint CoverBuffer::footprint(const BoxPixels& boxes, std::size_t i) const {
  const float most = boxes.most[i];
  const PixelRectangle r{boxes.x0[i], boxes.y0[i], boxes.x1[i], boxes.y1[i]}, all{0, 0, picture_.width(), picture_.height()};
  if (most == std::numeric_limits<float>::infinity()) return {all, most, false, boxes.first_tile[i]};
  const bool is_in_picture = r.x0 >= 0 && r.y0 >= 0 && r.x1 <= all.x1 && r.y1 <= all.y1;
  return {picture_.clipped(r), most, is_in_picture, boxes.first_tile[i]};
}

float CoverBuffer::seen_size(const ProjectedBoxes& boxes, std::size_t i) const {
  // From another eye the box may look larger.
  if (is_of_region()) return std::numeric_limits<float>::infinity();
  if (boxes.most[i] == std::numeric_limits<float>::infinity()) return boxes.most[i];
  const double right = double{boxes.high_x[i]} - double{boxes.low_x[i]},
               up = double{boxes.high_y[i]} - double{boxes.low_y[i]};
  return rounded_up(std::max(right * share_of_pixel_.x, up * share_of_pixel_.y));
}

bool CoverBuffer::hides(const Footprint& box) const { return box.is_in_picture && open(box, 1) == 0; }

CoverBuffer::Gap CoverBuffer::gap(const kernel::Aabb& box) const {
  const ProjectedBoxes boxes = seen(box);
  if (hidden(boxes, 1) != 0) return Gap::none;
  const Footprint footprint = this->footprint(boxes, 0);
  if (!footprint.is_in_picture) return Gap::beyond_picture;
  const TilePicture layer = tile_picture().from(footprint.first_tile);
  const float never = boxes_.layers.start(layer_of(footprint));
  return open_pixels(layer, footprint.pixels, std::max(never, std::numeric_limits<float>::lowest()), 1) > 0
             ? Gap::open
             : Gap::not_behind;
}

std::size_t CoverBuffer::pixel_number(int first_tile, int x, int y) const {
  const auto tile = static_cast<std::size_t>(first_tile + y / kTile * tiles_across_ + x / kTile);
  return tile * kTilePixels + static_cast<std::size_t>(y % kTile * kTile + x % kTile);
}

CoverBuffer::Footprint CoverBuffer::hidden_at(const kernel::Aabb& box) const {
  const ProjectedBoxes boxes = seen(box);
  const Footprint farther = footprint(boxes, 0);
  return hides(farther) ? farther : footprint(boxes.nearer_layer, 0);
}

/// By itself, the box may ask other layers.
CoverBuffer::Footprint CoverBuffer::within(const Footprint& whole, const kernel::Aabb& box) const {
  BoxPicture of_layer = boxes_;
  of_layer.layers.focus[0] = boxes_.layers.focus[layer_of(whole)];
  of_layer.layers.count = 1;
  ProjectedBoxes boxes;
  boxes.add(of_layer, box);
  boxes.project(of_layer);
  const PixelRectangle a = whole.pixels, b = footprint(boxes, 0).pixels;
  Footprint part = whole;
  part.pixels = {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
  return part;
}

/// Finds windows of a footprint in which a box is hidden. A pixel whose owner is too far is closed through the nearer layer.
class CoverBuffer::WindowFinder {
 public:
  WindowFinder(const CoverBuffer& buffer, const Footprint& at) : buffer_(buffer), at_(at) {
    const PixelRectangle& r = at.pixels;
    for (int y = r.y0; y < r.y1; ++y) {
      for (int x = r.x0; x < r.x1; ++x) {
        const std::size_t pixel = buffer.pixel_number(at.first_tile, x, y);
        const bool is_owned = buffer.owned_[pixel] > at.most;
        pixels_.push_back({is_owned ? buffer.owners_[pixel] : kNone, false});
      }
    }
  }

  std::vector<Window> find() {
    find_through(at_.pixels);
    find_sheets();
    return std::move(windows_);
  }

 private:
  struct Pixel {
    std::uint32_t sheet;  ///< kNone: it is closed through the nearer layer
    bool is_found;        ///< in a window

    friend bool operator==(const Pixel&, const Pixel&) = default;
  };

  [[nodiscard]] Pixel& pixel(int x, int y) {
    const PixelRectangle& r = at_.pixels;
    return pixels_[static_cast<std::size_t>((y - r.y0) * (r.x1 - r.x0) + x - r.x0)];
  }

  /// Of the pixels that are closed through the nearer layer, as few rectangles as halving finds that are closed as a whole.
  void find_through(const PixelRectangle& within) {
    PixelRectangle r{within.x1, within.y1, within.x0, within.y0};
    for (int y = within.y0; y < within.y1; ++y) {
      for (int x = within.x0; x < within.x1; ++x) {
        if (pixel(x, y).sheet == kNone) r = {std::min(r.x0, x), std::min(r.y0, y), std::max(r.x1, x + 1), y + 1};
      }
    }
    if (r.x0 >= r.x1) return;
    const Window window{r, kNone};
    const bool is_pixel = r.x1 - r.x0 == 1 && r.y1 - r.y0 == 1;  // and so closed
    if (is_pixel || buffer_.hides(buffer_.through(at_, window))) {
      for (int y = r.y0; y < r.y1; ++y) {
        for (int x = r.x0; x < r.x1; ++x) pixel(x, y).is_found = true;
      }
      return windows_.push_back(window);
    }
    PixelRectangle low = r, high = r;
    if (r.x1 - r.x0 >= r.y1 - r.y0) {
      low.x1 = high.x0 = r.x0 + (r.x1 - r.x0) / 2;
    } else {
      low.y1 = high.y0 = r.y0 + (r.y1 - r.y0) / 2;
    }
    find_through(low);
    find_through(high);
  }

  /// Runs of other pixels in rows, of which those that lie above each other are one window.
  void find_sheets() {
    const PixelRectangle& r = at_.pixels;
    for (int y = r.y0; y < r.y1; ++y) {
      for (int x = r.x0, end = x; x < r.x1; x = end) {
        const Pixel first = pixel(x, y);
        while (end < r.x1 && pixel(end, y) == first) ++end;
        if (!first.is_found) add({{x, y, end, y + 1}, first.sheet});
      }
    }
  }

  void add(const Window& run) {
    const auto below = std::ranges::find_if(windows_, [&](const Window& w) {
      return w.sheet == run.sheet && w.pixels.x0 == run.pixels.x0 && w.pixels.x1 == run.pixels.x1 &&
             w.pixels.y1 == run.pixels.y0;
    });
    if (below == windows_.end()) return windows_.push_back(run);
    below->pixels.y1 = run.pixels.y1;
  }

  const CoverBuffer& buffer_;
  const Footprint& at_;
  std::vector<Pixel> pixels_;  ///< row by row
  std::vector<Window> windows_;
};

CoverBuffer::Windows CoverBuffer::windows(const Footprint& at) const {
  return {boxes_.layers.focus[layer_of(at)], WindowFinder(*this, at).find()};
}

CoverBuffer::Footprint CoverBuffer::through(const Footprint& at, const Window& window) const {
  const std::size_t layer = layer_of(at);
  const PixelRectangle r = erosion_.through(layer, window.pixels);
  const bool is_in_picture = r.x0 >= 0 && r.y0 >= 0 && r.x1 <= picture_.width() && r.y1 <= picture_.height();
  // What the nearer layer starts with is not closed.
  return {r, std::max(at.most, boxes_.layers.start(layer + 1)), is_in_picture, at.first_tile + boxes_.tiles_of_layer};
}

std::vector<CoverBuffer::Owner> CoverBuffer::owners(const kernel::Aabb& box) const {
  const ProjectedBoxes boxes = seen(box);
  const PixelPosition low{boxes.low_x[0], boxes.low_y[0]}, high{boxes.high_x[0], boxes.high_y[0]};
  const PixelRectangle r = footprint(boxes, 0).pixels;
  std::vector<Owner> runs;
  for (int y = r.y0; y < r.y1; ++y) {
    std::uint32_t last = kNone;
    for (int x = r.x0; x < r.x1; ++x) {
      const std::uint32_t id = owners_[pixel_number(0, x, y)];
      const PixelBounds pixel{{std::max<double>(x, low.x), std::max<double>(y, low.y)},
                              {std::min<double>(x + 1, high.x), std::min<double>(y + 1, high.y)}};
      const bool is_of_box = pixel.low.x <= pixel.high.x && pixel.low.y <= pixel.high.y;  // else only the margin reaches it
      if (!is_of_box || id == kNone) {
        last = kNone;
      } else if (id == last) {
        runs.back().places.high.x = pixel.high.x;
      } else {
        runs.push_back({id, pixel});
        last = id;
      }
    }
  }
  std::ranges::stable_sort(runs, {}, &Owner::id);
  std::vector<Owner> owners;
  for (const auto& [id, pixel] : runs) {
    if (owners.empty() || owners.back().id != id) owners.push_back({id, pixel});
    PixelBounds& all = owners.back().places;
    all = {{std::min(all.low.x, pixel.low.x), std::min(all.low.y, pixel.low.y)},
           {std::max(all.high.x, pixel.high.x), std::max(all.high.y, pixel.high.y)}};
  }
  return owners;
}

}  // namespace occlude::culler
