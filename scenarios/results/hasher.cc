// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/hasher.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace horopter::scenarios {
namespace {

void Demand(int succeeded) {
  if (succeeded != 1) throw std::runtime_error("OpenSSL cannot compute SHA-256");
}

}  // namespace

void Hasher::Free::operator()(evp_md_ctx_st* context) const { EVP_MD_CTX_free(context); }

Hasher::Context Hasher::MakeContext() {
  Context context(EVP_MD_CTX_new());
  Demand(context != nullptr);
  return context;
}

Hasher::Hasher() : context_(MakeContext()) {
  Demand(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
}

void Hasher::Update(std::span<const std::byte> bytes) {
  Demand(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
}

void Hasher::Update(std::string_view text) {
  Update(static_cast<std::uint64_t>(text.size()));
  Update(std::as_bytes(std::span(text)));
}

void Hasher::Update(const cv::Mat& image) {
  Update(image.type());
  Update(image.rows);
  Update(image.cols);
  const std::size_t row_bytes = image.cols * image.elemSize();
  for (int y = 0; y < image.rows; ++y) {
    Update(std::as_bytes(std::span(image.ptr<std::uint8_t>(y), row_bytes)));
  }
}

void Hasher::Update(double value) {
  if (std::isnan(value)) value = std::numeric_limits<double>::quiet_NaN();
  Update(std::bit_cast<std::uint64_t>(value));
}

void Hasher::Update(std::uint64_t value) {
  std::array<std::byte, 8> bytes;
  for (int i = 0; i < 8; ++i) bytes[i] = static_cast<std::byte>(value >> (8 * i));
  Update(bytes);
}

std::string Hasher::Hex() const {
  const Context ended = MakeContext();
  Demand(EVP_MD_CTX_copy_ex(ended.get(), context_.get()));
  std::array<unsigned char, 32> digest;
  Demand(EVP_DigestFinal_ex(ended.get(), digest.data(), nullptr));
  std::string hex;
  for (const unsigned char byte : digest) hex += fmt::format("{:02x}", byte);
  return hex;
}

}  // namespace horopter::scenarios
