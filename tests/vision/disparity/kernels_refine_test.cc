// SPDX-License-Identifier: Apache-2.0
// What comes of products and pooled lanes, of every instruction set: where the mathematics says
// that the closed form equals the population form, it does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "kernel_test.h"
#include "random_cells.h"
#include "vision/disparity/binocular_energy.h"
#include "vision/disparity/closed_form_kernels.h"

namespace horopter::vision {
namespace {

using testing::ExtremeCells;
using testing::RandomCells;
using testing::Response;
using testing::Turn;
using Complex = std::complex<double>;

const cv::Size kSize(83, 21);
const std::size_t kPixels = static_cast<std::size_t>(kSize.area());

/// A lane of a product is half of what the bytes' product is.
constexpr double kProductUnit = 2;
/// Rounding, at most, for the largest cells [lanes]: the right cell has 14 bits, of which one
/// bilinear mean and three turns lose ten units, and the product adds its own. Lanes reach 16130.
constexpr double kProductTolerance = 8;

class RefineKernels : public testing::KernelTest {
 protected:
  static ClosedFormConfig PublishedBank() {
    ClosedFormConfig config;
    config.orientations = kOrientations;
    config.peak_frequency = V1Config().peak_frequency;
    return config;
  }

  /// L conj(R) of all pixels, R at dx_, dy_.
  void Multiply(const CellImage& left, const CellImage& right) {
    const ProductTask task{left.view(), right.view(),    dx_.data(),
                           dy_.data(),  &bank_.tables(), products_.data()};
    for (int y = 0; y < kSize.height; ++y) kernels_.multiply_row(task, y);
  }
  void MoveAll(float dx, float dy) {
    std::fill(dx_.begin(), dx_.end(), dx);
    std::fill(dy_.begin(), dy_.end(), dy);
  }
  Complex Product(int x, int y, int orientation) const {
    const std::int16_t* lanes = &products_[(std::size_t(y) * kSize.width + x) * kLanes];
    return {static_cast<double>(lanes[orientation]),
            static_cast<double>(lanes[kMaxCellOrientations + orientation])};
  }
  /// Between pixels: the mean of the four around, each turned to the position.
  Complex ResponseAt(const CellView& cells, double x, double y, int o) const {
    const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
    Complex sum = 0;
    for (const int py : {y0, y0 + 1}) {
      for (const int px : {x0, x0 + 1}) {
        const double weight = (1 - std::abs(x - px)) * (1 - std::abs(y - py));
        if (weight == 0) continue;
        sum += weight * Response(cells, px, py, o) * Turn(bank_, o, x - px, y - py);
      }
    }
    return sum;
  }
  void ExpectProducts(const CellImage& left, const CellImage& right) const;

  CellBank bank_{PublishedBank()};
  std::vector<float> dx_ = std::vector<float>(kPixels + 16);
  std::vector<float> dy_ = std::vector<float>(kPixels + 16);
  std::vector<std::int16_t> products_ = std::vector<std::int16_t>(kPixels * kLanes, 7);
};

INSTANTIATE_TEST_SUITE_P(All, RefineKernels, testing::EveryKernel(), testing::NameOf);

void RefineKernels::ExpectProducts(const CellImage& left, const CellImage& right) const {
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const double to_x = x + dx_[y * kSize.width + x], to_y = y + dy_[y * kSize.width + x];
      const bool inside =
          to_x >= 0 && to_y >= 0 && to_x <= kSize.width - 1 && to_y <= kSize.height - 1;
      for (int o = 0; o < bank_.orientations(); ++o) {
        const Complex found = Product(x, y, o);
        if (!inside) {
          ASSERT_EQ(found, Complex(0)) << x << " " << y;
          continue;
        }
        const Complex expected =
            Response(left.view(), x, y, o) * std::conj(ResponseAt(right.view(), to_x, to_y, o));
        ASSERT_NEAR(found.real(), expected.real() / kProductUnit, kProductTolerance)
            << x << " " << y << " to " << to_x << " " << to_y << " orientation " << o;
        ASSERT_NEAR(found.imag(), expected.imag() / kProductUnit, kProductTolerance)
            << x << " " << y << " to " << to_x << " " << to_y << " orientation " << o;
      }
    }
  }
}

TEST_P(RefineKernels, ProductsAtWholePositionsAreThoseOfTheCells) {
  const CellImage left = RandomCells(kSize, kOrientations, 1);
  const CellImage right = RandomCells(kSize, kOrientations, 2);
  for (const cv::Point move : {cv::Point(0, 0), {5, -2}, {-30, 4}, {1, 20}}) {
    MoveAll(static_cast<float>(move.x), static_cast<float>(move.y));
    Multiply(left, right);
    ExpectProducts(left, right);
  }
}

/// Positions lie on the 64ths of a pixel that the tables have.
TEST_P(RefineKernels, ProductsBetweenPixelsAreThoseOfTurnedMeans) {
  cv::RNG random(3);
  for (std::size_t i = 0; i < kPixels; ++i) {
    dx_[i] = static_cast<float>(random.uniform(-640, 640)) / 64;
    dy_[i] = static_cast<float>(random.uniform(-320, 320)) / 64;
  }
  for (const auto& make : {RandomCells, ExtremeCells}) {
    const CellImage left = make(kSize, kOrientations, 1), right = make(kSize, kOrientations, 2);
    Multiply(left, right);
    ExpectProducts(left, right);
  }
}

/// Any other position is taken as the nearest one on the grid, half a 64th away at most.
TEST_P(RefineKernels, PositionsAreRoundedToA64th) {
  const CellImage left = RandomCells(kSize, kOrientations, 1);
  const CellImage right = RandomCells(kSize, kOrientations, 2);
  for (const float offset : {-0.45F, -0.2F, 0.2F, 0.45F}) {
    MoveAll((96 + offset) / 64, (32 - offset) / 64);
    Multiply(left, right);
    MoveAll(96.0F / 64, 32.0F / 64);
    for (int y = 0; y < kSize.height - 1; ++y) {
      for (int x = 0; x < kSize.width - 2; ++x) {
        const Complex expected = Response(left.view(), x, y, 2) *
                                 std::conj(ResponseAt(right.view(), x + 1.5, y + 0.5, 2));
        ASSERT_NEAR(Product(x, y, 2).real(), expected.real() / kProductUnit, kProductTolerance);
      }
    }
  }
}

TEST_P(RefineKernels, NowhereGivesNoProduct) {
  const CellImage cells = RandomCells(kSize, kOrientations, 1);
  for (const float far : {1e6F, -1e6F, std::numeric_limits<float>::infinity(), std::nanf("")}) {
    MoveAll(far, 0);
    Multiply(cells, cells);
    EXPECT_TRUE(std::all_of(products_.begin(), products_.end(), [](int lane) { return lane == 0; }))
        << far;
  }
}

/// The population's phase shifts, 2009's or equally spaced over the whole circle.
V1Config Published() { return V1Config(); }
V1Config RoundTheCircle() {
  V1Config config;
  config.max_disparity_px = 3.0 / kPhaseShifts / config.peak_frequency;
  return config;
}

/// The squared energies of a pixel's population, by the code of the population form.
class PopulationOf {
 public:
  PopulationOf(const V1Config& config, const CellView& left, int x, int y, const CellView& right,
               int right_x, int right_y)
      : energy_(config) {
    PerOrientation left_even, left_odd, right_even, right_odd;
    for (int o = 0; o < kOrientations; ++o) {
      const Complex l = Response(left, x, y, o), r = Response(right, right_x, right_y, o);
      left_even[o] = static_cast<float>(l.real());
      left_odd[o] = static_cast<float>(l.imag());
      right_even[o] = static_cast<float>(r.real());
      right_odd[o] = static_cast<float>(r.imag());
    }
    energy_.Magnitudes<0, 0>({left_even.data(), left_odd.data()},
                             {right_even.data(), right_odd.data()}, energies_);
  }
  double Squared(int shift, int orientation) const {
    return std::pow(energies_[shift][orientation], 2);
  }
  /// Phase that a shift's cells advance the right response by, from the disparity they prefer.
  double Phase(int shift) const {
    return 2 * M_PI * V1Config().peak_frequency * energy_.preferred(shift);
  }

 private:
  BinocularEnergy energy_;
  BinocularEnergy::Energies energies_{};
};

TEST_P(RefineKernels, OneProductHoldsThePopulationsEnergyAtEveryPhaseShift) {
  const CellImage left = RandomCells(kSize, kOrientations, 1);
  const CellImage right = RandomCells(kSize, kOrientations, 2);
  const int dx = 3, dy = -2;
  MoveAll(dx, dy);
  Multiply(left, right);
  // Twice the product's rounding, in both of its parts, counts twice.
  const double tolerance = 2 * kProductUnit * std::sqrt(2) * kProductTolerance;
  for (int y = 2; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width - 3; ++x) {
      const PopulationOf population(Published(), left.view(), x, y, right.view(), x + dx, y + dy);
      for (int o = 0; o < kOrientations; ++o) {
        const Complex product = kProductUnit * Product(x, y, o);
        const double powers = std::norm(Response(left.view(), x, y, o)) +
                              std::norm(Response(right.view(), x + dx, y + dy, o));
        for (int j = 0; j < kPhaseShifts; ++j) {
          const double closed =
              powers + 2 * std::abs(product) * std::cos(std::arg(product) - population.Phase(j));
          ASSERT_NEAR(closed, population.Squared(j, o), tolerance) << o << " shift " << j;
        }
      }
    }
  }
}

TEST_P(RefineKernels, ThePhaseIsWhatALinearDecodingOfSquaredEnergiesGives) {
  // Sum over equally spaced shifts of energy^2 exp(i shift): the mean drops out, and what is left
  // points to the shift that agrees best.
  const CellImage left = RandomCells(kSize, kOrientations, 1);
  const CellImage right = RandomCells(kSize, kOrientations, 2);
  MoveAll(0, 0);
  Multiply(left, right);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const PopulationOf population(RoundTheCircle(), left.view(), x, y, right.view(), x, y);
      for (int o = 0; o < kOrientations; ++o) {
        Complex decoded = 0;
        for (int j = 0; j < kPhaseShifts; ++j) {
          decoded += population.Squared(j, o) * std::polar(1.0, population.Phase(j));
        }
        const Complex expected = decoded / (kPhaseShifts * kProductUnit);
        ASSERT_LT(std::abs(Product(x, y, o) - expected), std::sqrt(2) * kProductTolerance);
      }
    }
  }
}

/// Steps of products that are not pooled, on one row.
class SolveKernels : public testing::KernelTest {
 protected:
  static constexpr int kWidth = 61;  // not whole vectors, and fewer than a block

  SolveKernels() {
    task_.pool = {products_.data(), kWidth, 1, edges_.data(), &unpooled_};
    task_.orientations = bank_.orientations();
    for (int o = 0; o < bank_.orientations(); ++o) {
      task_.nx[o] = static_cast<float>(bank_.nx(o));
      task_.ny[o] = static_cast<float>(bank_.ny(o));
    }
    task_.px_per_rad = static_cast<float>(bank_.px_per_rad());
    task_.ridge = 0.02F;
    task_.max_step_px = 100;
    task_.dx = dx_.data();
    task_.dy = dy_.data();
  }
  void SetProduct(int x, int orientation, Complex product) {
    products_[x * kLanes + orientation] = static_cast<std::int16_t>(std::lround(product.real()));
    products_[x * kLanes + kMaxCellOrientations + orientation] =
        static_cast<std::int16_t>(std::lround(product.imag()));
  }
  /// Weighted least squares of n.d = phase / (2 pi f0) with the ridge, in double.
  cv::Vec2d LeastSquares(int x) const {
    cv::Matx22d normal = cv::Matx22d::zeros();
    cv::Vec2d pull(0, 0);
    for (int o = 0; o < bank_.orientations(); ++o) {
      const Complex product(products_[x * kLanes + o],
                            products_[x * kLanes + kMaxCellOrientations + o]);
      const cv::Vec2d n(bank_.nx(o), bank_.ny(o));
      normal += std::abs(product) * n * n.t();
      pull += std::abs(product) * std::arg(product) * bank_.px_per_rad() * n;
    }
    const double ridge = double{task_.ridge} * cv::trace(normal) + 1e-6;
    return (normal + ridge * cv::Matx22d::eye()).inv() * pull;
  }

  CellBank bank_{ClosedFormConfig()};
  std::vector<std::int16_t> products_ = std::vector<std::int16_t>(kWidth * kLanes);
  std::vector<std::uint8_t> edges_ = std::vector<std::uint8_t>(kWidth + 16);
  PoolingWeights unpooled_{};
  std::vector<float> dx_ = std::vector<float>(kWidth + 16, 3.0F);
  std::vector<float> dy_ = std::vector<float>(kWidth + 16, -1.0F);
  SolveTask task_{};
};

INSTANTIATE_TEST_SUITE_P(All, SolveKernels, testing::EveryKernel(), testing::NameOf);

TEST_P(SolveKernels, TheStepIsTheLeastSquaresSolution) {
  cv::RNG random(4);
  for (int x = 0; x < kWidth; ++x) {
    for (int o = 0; o < bank_.orientations(); ++o) {
      SetProduct(x, o, std::polar(random.uniform(100.0, 16000.0), random.uniform(-3.1, 3.1)));
    }
  }
  kernels_.solve(task_, 0, kWidth);
  // The angle is good to 1e-4 rad, which the least squares of six orientations do not double.
  const double tolerance = 2e-4 * bank_.px_per_rad() + 1e-6;
  for (int x = 0; x < kWidth; ++x) {
    const cv::Vec2d step = LeastSquares(x);
    EXPECT_NEAR(dx_[x], 3 + step[0], tolerance) << x;
    EXPECT_NEAR(dy_[x], -1 + step[1], tolerance) << x;
  }
}

TEST_P(SolveKernels, OneOrientationMovesAlongItself) {
  for (int x = 0; x < kWidth; ++x) SetProduct(x, x % 6, std::polar(9000.0, 1.0));
  kernels_.solve(task_, 0, kWidth);
  for (int x = 0; x < kWidth; ++x) {
    const double along = bank_.px_per_rad() / (1 + double{task_.ridge});
    // What crosses the orientation is held by the ridge alone, which leaves 1e-4 rad and float's
    // rounding fifty times larger.
    EXPECT_NEAR(dx_[x], 3 + along * bank_.nx(x % 6), 2e-3) << x;
    EXPECT_NEAR(dy_[x], -1 + along * bank_.ny(x % 6), 2e-3) << x;
  }
}

TEST_P(SolveKernels, StepsAreCutToTheLongestInTheirDirection) {
  task_.max_step_px = 0.05F;
  for (int x = 0; x < kWidth; ++x) {
    for (int o = 0; o < bank_.orientations(); ++o) {
      SetProduct(x, o, std::polar(9000.0, (0.1 * x - 3) * bank_.nx(o) + 0.4 * bank_.ny(o)));
    }
  }
  kernels_.solve(task_, 0, kWidth);
  for (int x = 0; x < kWidth; ++x) {
    cv::Vec2d step = LeastSquares(x);
    step *= std::min(1.0, 0.05 / cv::norm(step));
    EXPECT_NEAR(dx_[x], 3 + step[0], 1e-4) << x;
    EXPECT_NEAR(dy_[x], -1 + step[1], 1e-4) << x;
  }
}

TEST_P(SolveKernels, NoProductMovesNothing) {
  kernels_.solve(task_, 0, kWidth);
  EXPECT_TRUE(std::all_of(dx_.begin(), dx_.end(), [](float d) { return d == 3; }));
  EXPECT_TRUE(std::all_of(dy_.begin(), dy_.end(), [](float d) { return d == -1; }));
}

TEST_P(SolveKernels, ColumnsOutsideTheBlockStay) {
  for (int x = 0; x < kWidth; ++x) {
    for (int o = 0; o < bank_.orientations(); ++o) SetProduct(x, o, std::polar(9000.0, 0.5));
  }
  kernels_.solve(task_, 5, 18);
  for (int x = 0; x < kWidth; ++x) EXPECT_EQ(dx_[x] != 3 || dy_[x] != -1, x >= 5 && x < 18) << x;
}

}  // namespace
}  // namespace horopter::vision
