// SPDX-License-Identifier: MIT
#include "gunzip.h"

#include <zlib.h>

#include <new>
#include <utility>

namespace occlude::render {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 18U;  // of few calls, and small beside a line
constexpr int kGzip = 16 + MAX_WBITS;                  // the header of gzip, as zlib is told

}  // namespace

Gunzip::Gunzip() : stream_(new z_stream{}) {
  if (inflateInit2(stream_, kGzip) == Z_OK) return;
  delete stream_;
  throw std::bad_alloc();
}

Gunzip::~Gunzip() {
  inflateEnd(stream_);
  delete stream_;
}

void Gunzip::feed(std::string compressed) {
  compressed_ = std::move(compressed);
  stream_->next_in = reinterpret_cast<Bytef*>(compressed_.data());
  stream_->avail_in = static_cast<uInt>(compressed_.size());
}

bool Gunzip::next(std::string& block) {
  block.resize(kBlock);
  stream_->next_out = reinterpret_cast<Bytef*>(block.data());
  stream_->avail_out = static_cast<uInt>(block.size());
  for (;;) {
    if (is_complete_) {
      for (; stream_->avail_in > 0 && *stream_->next_in == 0; --stream_->avail_in) ++stream_->next_in;  // as gzip: tapes
      if (stream_->avail_in == 0) break;
      inflateReset(stream_);  // one compressed file may follow another
    }
    const int status = inflate(stream_, Z_NO_FLUSH);
    if (status == Z_BUF_ERROR) break;  // no more without room, or more bytes
    if (status != Z_OK && status != Z_STREAM_END) return false;
    is_complete_ = status == Z_STREAM_END;
  }
  block.resize(block.size() - stream_->avail_out);
  return true;
}

}  // namespace occlude::render
