// SPDX-License-Identifier: Apache-2.0
// Damaged files get a message, never a crash and never room for what they only claim to hold.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/dataset/flo.h"
#include "scenarios/dataset/image_file.h"
#include "scenarios/dataset/pfm.h"
#include "scenarios/dataset/png16.h"
#include "tests/scenarios/dataset/bytes.h"

namespace horopter::scenarios {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;

/// Counts the largest matrix that anyone asks for while it lives.
class AllocationWatch : public cv::MatAllocator {
 public:
  AllocationWatch() : real_(cv::Mat::getDefaultAllocator()) { cv::Mat::setDefaultAllocator(this); }
  ~AllocationWatch() override { cv::Mat::setDefaultAllocator(real_); }

  std::size_t largest() const { return largest_; }

  cv::UMatData* allocate(int dims, const int* sizes, int type, void* data, std::size_t* step,
                         cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    std::size_t bytes = CV_ELEM_SIZE(type);
    for (int i = 0; i < dims; ++i) bytes *= static_cast<std::size_t>(sizes[i]);
    largest_ = std::max(largest_, bytes);
    return real_->allocate(dims, sizes, type, data, step, flags, usage);
  }
  bool allocate(cv::UMatData* data, cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    return real_->allocate(data, flags, usage);
  }
  void deallocate(cv::UMatData* data) const override { real_->deallocate(data); }

 private:
  cv::MatAllocator* real_;
  mutable std::size_t largest_ = 0;
};

/// A file with one to four things wrong with it.
class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : random_(seed) {}

  std::string operator()(std::string bytes) {
    for (int i = Below(4); i >= 0; --i) Damage(bytes);
    return bytes;
  }

 private:
  int Below(std::size_t n) { return static_cast<int>(random_() % std::max<std::size_t>(n, 1)); }

  void Damage(std::string& bytes) {
    constexpr std::size_t kHeader = 48;
    // Half of the damage is in the header, where it does the most.
    const std::size_t reach = Below(2) == 0 ? std::min(bytes.size(), kHeader) : bytes.size();
    const auto at = static_cast<std::size_t>(Below(reach));
    switch (Below(6)) {
      case 0:
        if (!bytes.empty()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << Below(8)));
        break;
      case 1:
        if (!bytes.empty()) bytes[at] = static_cast<char>(Below(256));
        break;
      case 2:  // the numbers that arithmetic stumbles over
        for (std::size_t i = at; i < std::min(at + 4, bytes.size()); ++i) {
          bytes[i] = "\x7f\xff\x80\0"[Below(4)];
        }
        break;
      case 3:
        bytes.resize(at);
        break;
      case 4:
        bytes.insert(at,
                     std::string(static_cast<std::size_t>(1 + Below(9)), "09 -\n\xff"[Below(6)]));
        break;
      default:
        bytes.erase(at, static_cast<std::size_t>(1 + Below(9)));
    }
  }

  std::mt19937 random_;
};

/// CRC-32 of ISO 3309, as PNG has it.
std::uint32_t Crc(std::string_view bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char byte : bytes) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc % 2 == 0 ? 0 : 0xedb88320);
  }
  return ~crc;
}

/// Makes the check sum of every PNG chunk right: without it all damage ends at the check sum.
std::string WithCheckSums(std::string png) {
  constexpr std::size_t kSignature = 8, kAround = 12;
  std::size_t at = kSignature;
  while (at + kAround <= png.size()) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      length = length << 8 | static_cast<std::uint8_t>(png[at + i]);
    }
    if (length > png.size() - at - kAround) break;
    const std::uint32_t crc = Crc(std::string_view(png).substr(at + 4, 4 + length));
    for (std::size_t i = 0; i < 4; ++i) {
      png[at + 8 + length + i] = static_cast<char>(crc >> (24 - 8 * i) & 0xff);
    }
    at += kAround + length;
  }
  return png;
}

using Reader = std::function<cv::Mat(const std::string& bytes)>;

void Fuzz(const std::string& valid, const Reader& read) {
  constexpr int rounds = 2000;
  ASSERT_FALSE(read(valid).empty());
  Mutator mutate(1);
  AllocationWatch watch;
  int refused = 0;
  for (int i = 0; i < rounds; ++i) {
    std::string damaged = mutate(valid);
    if (i % 2 == 0 && damaged.starts_with("\x89PNG")) damaged = WithCheckSums(damaged);
    try {
      const cv::Mat pixels = read(damaged);
      EXPECT_FALSE(pixels.empty()) << "mutation " << i;
    } catch (const FormatError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).substr(0, 3), "f: ") << "mutation " << i;
    }
    ASSERT_LE(watch.largest(), kMostBytes) << "mutation " << i;
  }
  EXPECT_GT(refused, rounds / 10) << "the mutations hardly damage anything";
  EXPECT_LT(refused, rounds) << "nothing gets past the header";
}

cv::Mat Picture(int type) {
  cv::Mat pixels(13, 9, type);
  cv::RNG random(5);
  random.fill(pixels, cv::RNG::UNIFORM, 0, CV_MAT_DEPTH(type) == CV_16U ? 65536 : 256);
  return pixels;
}

std::string Encoded(const char* extension, int type) {
  std::vector<uchar> bytes;
  EXPECT_TRUE(cv::imencode(extension, Picture(type), bytes));
  return {bytes.begin(), bytes.end()};
}

TEST(ReaderFuzz, Flo) {
  Fuzz(EncodeFlo({Picture(CV_32FC1), Picture(CV_32FC1)}),
       [](const std::string& bytes) { return DecodeFlo(bytes, "f").dx; });
}

TEST(ReaderFuzz, Pfm) {
  Fuzz(EncodePfm(Picture(CV_32FC1)),
       [](const std::string& bytes) { return DecodePfm(bytes, "f"); });
  Fuzz(EncodePfm(Picture(CV_32FC3)),
       [](const std::string& bytes) { return DecodePfm(bytes, "f"); });
}

TEST(ReaderFuzz, Png16) {
  Fuzz(EncodePng(Picture(CV_16UC1)),
       [](const std::string& bytes) { return DecodePng16(bytes, 1, "f"); });
  Fuzz(EncodePng(Picture(CV_16UC3)),
       [](const std::string& bytes) { return DecodePng16(bytes, 3, "f"); });
}

class ReaderFuzzImages : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Formats, ReaderFuzzImages,
                         testing::Values(".png", ".jpg", ".pgm", ".ppm", ".bmp", ".tiff"),
                         [](const auto& instance) { return std::string(instance.param + 1); });

TEST_P(ReaderFuzzImages, AnyFormat) {
  const std::string extension = GetParam();
  Fuzz(Encoded(GetParam(), extension == ".pgm" ? CV_8UC1 : CV_8UC3),
       [](const std::string& bytes) { return DecodeImage(bytes, "f"); });
}

}  // namespace
}  // namespace horopter::scenarios
