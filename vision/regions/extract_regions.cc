// SPDX-License-Identifier: Apache-2.0
#include "vision/regions/extract_regions.h"

#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "hardware/types/field_checker.h"

namespace horopter::vision {
namespace {

std::string Text(cv::Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

void CheckInput(const cv::Mat1b& interior, const cv::Mat& bgr, const cv::Mat1f& depth) {
  if (!bgr.empty() && (bgr.type() != CV_8UC3 || bgr.size() != interior.size())) {
    throw std::invalid_argument("regions: the image is " + cv::typeToString(bgr.type()) + " of " +
                                Text(bgr.size()) + ", the edge map " + Text(interior.size()) +
                                ": both must be of one size and the image CV_8UC3");
  }
  if (!depth.empty() && depth.size() != interior.size()) {
    throw std::invalid_argument("regions: the depth map is " + Text(depth.size()) +
                                ", the edge map " + Text(interior.size()) +
                                ": both must be of one size");
  }
}

/// Labels in scan order, without the small ones; fills in all that labelling itself yields.
RegionMap Label(const cv::Mat1b& interior, int min_area_px) {
  RegionMap map;
  cv::Mat1i stats;
  cv::Mat1d centroids;
  const int count =
      cv::connectedComponentsWithStats(interior, map.labels, stats, centroids, 8, CV_32S);

  constexpr int kUnseen = -1;
  std::vector<int> renumbered(count, kUnseen);
  renumbered[0] = 0;
  for (int v = 0; v < map.labels.rows; ++v) {
    for (int& label : cv::Mat1i(map.labels.row(v))) {
      int& number = renumbered[label];
      if (number == kUnseen) {
        const bool small = stats(label, cv::CC_STAT_AREA) < min_area_px;
        number = small ? 0 : static_cast<int>(map.regions.size()) + 1;
        if (!small) {
          Region region;
          region.label = number;
          region.area_px = stats(label, cv::CC_STAT_AREA);
          region.box = {stats(label, cv::CC_STAT_LEFT), stats(label, cv::CC_STAT_TOP),
                        stats(label, cv::CC_STAT_WIDTH), stats(label, cv::CC_STAT_HEIGHT)};
          region.centroid = {centroids(label, 0), centroids(label, 1)};
          map.regions.push_back(region);
        }
      }
      label = number;
    }
  }
  return map;
}

void MeasureColour(const cv::Mat& bgr, RegionMap& map) {
  std::vector<cv::Vec<std::int64_t, 3>> sums(map.regions.size() + 1);
  for (int v = 0; v < bgr.rows; ++v) {
    const cv::Vec3b* colours = bgr.ptr<cv::Vec3b>(v);
    const int* labels = map.labels[v];
    for (int u = 0; u < bgr.cols; ++u) {
      for (int c = 0; c < 3; ++c) sums[labels[u]][c] += colours[u][c];
    }
  }
  for (Region& region : map.regions) {
    for (int c = 0; c < 3; ++c) {
      region.mean_bgr[c] = static_cast<double>(sums[region.label][c]) / region.area_px;
    }
  }
}

void MeasureDepth(const cv::Mat1f& depth, double near_fraction, RegionMap& map) {
  std::vector<std::vector<float>> depths(map.regions.size() + 1);
  for (int v = 0; v < depth.rows; ++v) {
    const float* row = depth[v];
    const int* labels = map.labels[v];
    for (int u = 0; u < depth.cols; ++u) {
      if (labels[u] != 0 && std::isfinite(row[u])) depths[labels[u]].push_back(row[u]);
    }
  }
  for (Region& region : map.regions) {
    region.depth = Summarise(depths[region.label], near_fraction);
  }
}

}  // namespace

std::vector<hardware::FieldError> RegionConfig::Validate() const {
  hardware::FieldChecker check("regions.");
  check.Require(min_area_px >= 1, "min_area_px", min_area_px, "must be at least 1");
  check.Require(near_fraction >= 0 && near_fraction < 1, "near_fraction", near_fraction,
                "must be at least 0 and less than 1");
  return check.Take();
}

RegionMap ExtractRegions(const cv::Mat1b& interior, const cv::Mat& bgr, const cv::Mat1f& depth,
                         const RegionConfig& config) {
  hardware::ThrowIfAny(config.Validate());
  CheckInput(interior, bgr, depth);
  if (interior.empty()) return {};
  RegionMap map = Label(interior, config.min_area_px);
  if (!bgr.empty()) MeasureColour(bgr, map);
  if (!depth.empty()) MeasureDepth(depth, config.near_fraction, map);
  return map;
}

}  // namespace horopter::vision
