// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/camera_yaml.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "scenarios/dataset/format_error.h"

namespace horopter::scenarios {
namespace {

using hardware::CameraModel;
using hardware::Pose;

template <typename Derived>
cv::Mat1d ToMat(const Eigen::MatrixBase<Derived>& m) {
  cv::Mat1d mat(static_cast<int>(m.rows()), static_cast<int>(m.cols()));
  for (int r = 0; r < mat.rows; ++r) {
    for (int c = 0; c < mat.cols; ++c) mat(r, c) = m(r, c);
  }
  return mat;
}

void WriteCamera(cv::FileStorage& file, const std::string& number, const sim::EyeView& view) {
  const auto& in = view.camera.intrinsics();
  const auto& d = view.camera.distortion();
  file << "size" + number << cv::Size(in.width, in.height);
  file << "K" + number << cv::Mat((cv::Mat1d(3, 3) << in.fx, 0, in.cx, 0, in.fy, in.cy, 0, 0, 1));
  file << "D" + number << cv::Mat((cv::Mat1d(1, 5) << d.k1, d.k2, d.p1, d.p2, d.k3));
  file << "X_WC" + number << ToMat(view.X_WC.matrix());
}

cv::Mat1d ReadMatrix(const cv::FileStorage& file, const std::string& key, int rows, int cols,
                     const std::string& name) {
  cv::Mat mat;
  if (file[key].isMap()) file[key] >> mat;
  if (mat.rows != rows || mat.cols != cols || mat.type() != CV_64FC1) {
    throw FormatError(
        fmt::format("{}: '{}' is not a {}x{} matrix of doubles", name, key, rows, cols));
  }
  return mat;
}

Pose ToPose(const cv::Mat1d& mat) {
  Pose X = Pose::Identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) X(r, c) = mat(r, c);
  }
  return X;
}

sim::EyeView ReadCamera(const cv::FileStorage& file, const std::string& number,
                        const std::string& name) {
  const cv::Mat1d K = ReadMatrix(file, "K" + number, 3, 3, name);
  const cv::Mat1d D = ReadMatrix(file, "D" + number, 1, 5, name);
  cv::Size size;
  file["size" + number] >> size;
  const Pose X_WC = ToPose(ReadMatrix(file, "X_WC" + number, 4, 4, name));
  try {
    return {X_WC, CameraModel({size.width, size.height, K(0, 0), K(1, 1), K(0, 2), K(1, 2)},
                              {D(0, 0), D(0, 1), D(0, 2), D(0, 3), D(0, 4)})};
  } catch (const hardware::ConfigError& e) {
    throw FormatError(fmt::format("{}: camera {}: {}", name, number, e.what()));
  }
}

}  // namespace

std::string EncodeCameras(const StereoViews& views) {
  cv::FileStorage file("cameras.yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  WriteCamera(file, "1", views.left);
  WriteCamera(file, "2", views.right);
  const Pose X_RL = views.right.X_WC.inverse(Eigen::Isometry) * views.left.X_WC;
  file << "R" << ToMat(X_RL.linear());
  file << "T" << ToMat(X_RL.translation());
  return file.releaseAndGetString();
}

StereoViews DecodeCameras(std::string_view yaml, const std::string& name) {
  try {
    const cv::FileStorage file(std::string(yaml), cv::FileStorage::READ | cv::FileStorage::MEMORY);
    if (!file.isOpened()) throw FormatError(fmt::format("{}: no YAML of OpenCV's", name));
    StereoViews views{ReadCamera(file, "1", name), ReadCamera(file, "2", name)};
    Pose X_RL = Pose::Identity();
    const cv::Mat1d R = ReadMatrix(file, "R", 3, 3, name), T = ReadMatrix(file, "T", 3, 1, name);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) X_RL(r, c) = R(r, c);
      X_RL(r, 3) = T(r, 0);
    }
    constexpr double kRounding = 1e-9;
    const Pose by_poses = views.right.X_WC.inverse(Eigen::Isometry) * views.left.X_WC;
    if (!by_poses.matrix().isApprox(X_RL.matrix(), kRounding)) {
      throw FormatError(fmt::format("{}: R and T contradict X_WC1 and X_WC2", name));
    }
    return views;
  } catch (const cv::Exception& e) {
    throw FormatError(fmt::format("{}: no YAML of OpenCV's: {}", name, e.err));
  }
}

}  // namespace horopter::scenarios
