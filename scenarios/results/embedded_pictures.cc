// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/embedded_pictures.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "scenarios/results/results_error.h"
#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace {

constexpr int kWidth = 360;

bool IsPhotograph(PictureKind kind) {
  return kind == PictureKind::kLeft || kind == PictureKind::kRight;
}

cv::Mat ScaledDown(const cv::Mat& picture, bool photograph) {
  if (picture.cols <= kWidth) return picture;
  const int height = std::max(
      1, static_cast<int>(std::lround(static_cast<double>(picture.rows) * kWidth / picture.cols)));
  cv::Mat small;
  // A coloured map is never mixed: colours in between would be values that were never measured.
  cv::resize(picture, small, {kWidth, height}, 0, 0,
             photograph ? cv::INTER_AREA : cv::INTER_NEAREST);
  return small;
}

EmbeddedFrame::Picture Embed(const ReportFrame::Picture& picture, bool maps_as_png) {
  const cv::Mat full = cv::imread(picture.file.string(), cv::IMREAD_COLOR);
  if (full.empty()) {
    throw ResultsError("cannot read the picture " + picture.file.string() +
                       " back for the report: run the scenario again");
  }
  const bool png = maps_as_png && !IsPhotograph(picture.kind);
  const bool smooth = IsPhotograph(picture.kind) || picture.kind == PictureKind::kRegions;
  const cv::Mat small = ScaledDown(full, smooth);
  std::vector<std::uint8_t> bytes;
  if (png) {
    cv::imencode(".png", small, bytes, {cv::IMWRITE_PNG_COMPRESSION, 9});
  } else {
    cv::imencode(".jpg", small, bytes, {cv::IMWRITE_JPEG_QUALITY, 85});
  }
  return {picture.kind,
          (png ? "data:image/png;base64," : "data:image/jpeg;base64,") + Base64(bytes), small.cols,
          small.rows};
}

std::vector<EmbeddedFrame> EmbedSome(const std::vector<ReportFrame>& frames, std::size_t most,
                                     bool maps_as_png) {
  std::vector<EmbeddedFrame> embedded;
  for (const std::size_t i : EvenlySpaced(frames.size(), most)) {
    EmbeddedFrame& frame = embedded.emplace_back();
    frame.record = frames[i].record;
    frame.scales = frames[i].scales;
    for (const ReportFrame::Picture& picture : frames[i].pictures) {
      frame.pictures.push_back(Embed(picture, maps_as_png));
    }
  }
  return embedded;
}

std::size_t Size(const std::vector<EmbeddedFrame>& frames) {
  std::size_t bytes = 0;
  for (const EmbeddedFrame& frame : frames) {
    for (const EmbeddedFrame::Picture& picture : frame.pictures) bytes += picture.data_uri.size();
  }
  return bytes;
}

}  // namespace

std::vector<EmbeddedFrame> EmbedFrames(const std::vector<ReportFrame>& frames,
                                       std::size_t budget_bytes) {
  struct Attempt {
    std::size_t most;
    bool maps_as_png;
  };
  std::vector<EmbeddedFrame> embedded;
  for (const Attempt attempt :
       {Attempt{13, true}, {13, false}, {7, false}, {3, false}, {1, false}}) {
    embedded = EmbedSome(frames, attempt.most, attempt.maps_as_png);
    if (Size(embedded) <= budget_bytes) break;
  }
  return embedded;
}

}  // namespace horopter::scenarios
