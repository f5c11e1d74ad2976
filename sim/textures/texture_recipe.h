// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace horopter::sim {

/// What a texture shows, as a scene writes it: "brick,size_m=5.2x2.6,course_m=0.08".
///
/// `size_m` is the surface that the texture covers: WxH for a flat one, XxYxZ (the box's edges)
/// for a cube texture. It makes bricks the same size on every wall. All other keys are numbers
/// that belong to the recipe (see `RecipeKeys`), but for `word`, which is lettering.
struct TextureRecipe {
  std::string kind;
  std::vector<double> size_m;                  ///< two or three edges [m]
  std::map<std::string, double> numbers;       ///< the recipe's own keys that were given
  std::map<std::string, std::string> words{};  ///< likewise, those that are text

  double Number(const std::string& key, double otherwise) const {
    const auto it = numbers.find(key);
    return it == numbers.end() ? otherwise : it->second;
  }
};

/// @param texture name of the texture, for messages
/// @throws hardware::ConfigError naming the texture, the bad part and what is possible.
TextureRecipe ParseTextureRecipe(std::string_view texture, std::string_view text);

/// Every recipe there is, sorted, and the keys that one of them takes.
std::vector<std::string> RecipeNames();
std::vector<std::string> RecipeKeys(const std::string& kind);

}  // namespace horopter::sim
