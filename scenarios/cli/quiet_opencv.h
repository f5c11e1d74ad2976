// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iostream>
#include <opencv2/core/utils/logger.hpp>
#include <sstream>

namespace horopter::scenarios {

/// While it lives, OpenCV's decoders keep to themselves what they complain about: the exception
/// that follows is the one line that the user gets. Not for use beside other threads that write
/// errors.
class QuietOpenCv {
 public:
  QuietOpenCv() = default;
  ~QuietOpenCv() {
    std::cerr.rdbuf(errors_);
    cv::utils::logging::setLogLevel(level_);
  }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;

 private:
  std::ostringstream sink_;
  std::streambuf* errors_ = std::cerr.rdbuf(sink_.rdbuf());
  cv::utils::logging::LogLevel level_ =
      cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
};

}  // namespace horopter::scenarios
