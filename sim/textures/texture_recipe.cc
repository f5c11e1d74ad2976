// SPDX-License-Identifier: Apache-2.0
#include "sim/textures/texture_recipe.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <optional>
#include <sstream>

#include "hardware/types/config_error.h"

namespace horopter::sim {

namespace {

const std::map<std::string, std::vector<std::string>>& Recipes() {
  static const std::map<std::string, std::vector<std::string>> kRecipes = {
      {"books", {"shelf_m"}},
      {"brick", {"course_m"}},
      {"cardboard", {}},
      {"carpet", {}},
      {"chessboard", {"square_m", "squares_x", "squares_y"}},
      {"crockery", {"accent_deg", "hue_deg", "print"}},
      {"curtain", {"hue_deg"}},
      {"die", {}},
      {"fabric", {"hue_deg"}},
      {"giraffe", {"hue_deg", "patches", "print"}},
      {"label", {"accent_deg", "hue_deg", "metal", "motif", "print", "word"}},
      {"grass", {}},
      {"marble", {}},
      {"package", {"accent_deg", "hue_deg", "motif", "print", "word"}},
      {"paper_print", {}},
      {"parquet", {"plank_m"}},
      {"plain_wall", {}},
      {"plaster", {}},
      {"poster", {}},
      {"red_paint", {}},
      {"tiger", {"hue_deg", "print", "stripes"}},
      {"wood", {"darkness"}},
  };
  return kRecipes;
}

/// The one key whose value is no number.
constexpr std::string_view kWord = "word";

bool IsWord(const std::string& text) {
  const auto fits = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ';
  };
  return !text.empty() && text.size() <= 12 && std::all_of(text.begin(), text.end(), fits);
}

std::string Join(const std::vector<std::string>& words) {
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : ", ") + word;
  return joined.empty() ? "none" : joined;
}

std::vector<std::string> Split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream{std::string(text)};
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// The whole text as a finite number, whatever the process' locale.
std::optional<double> ToNumber(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = 0;
  if (!(stream >> value) || !stream.eof() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::vector<double>> ToSize(const std::string& text) {
  std::vector<double> edges;
  for (const std::string& part : Split(text, 'x')) {
    const std::optional<double> edge = ToNumber(part);
    if (!edge || *edge <= 0) return std::nullopt;
    edges.push_back(*edge);
  }
  if (edges.size() != 2 && edges.size() != 3) return std::nullopt;
  return edges;
}

}  // namespace

std::vector<std::string> RecipeNames() {
  std::vector<std::string> names;
  for (const auto& [name, keys] : Recipes()) names.push_back(name);
  return names;
}

std::vector<std::string> RecipeKeys(const std::string& kind) {
  const auto it = Recipes().find(kind);
  return it == Recipes().end() ? std::vector<std::string>{} : it->second;
}

TextureRecipe ParseTextureRecipe(std::string_view texture, std::string_view text) {
  const std::string field = "texture:" + std::string(texture);
  const std::vector<std::string> parts = Split(text, ',');
  TextureRecipe recipe;
  recipe.kind = parts.empty() ? "" : parts.front();
  if (!Recipes().contains(recipe.kind)) {
    throw hardware::ConfigError(
        {{field, "\"" + recipe.kind + "\"", "must be one of " + Join(RecipeNames())}});
  }
  const std::vector<std::string> keys = RecipeKeys(recipe.kind);
  std::vector<hardware::FieldError> errors;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t equals = parts[i].find('=');
    const std::string key = parts[i].substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : parts[i].substr(equals + 1);
    if (key == "size_m") {
      const auto size = ToSize(value);
      if (size) recipe.size_m = *size;
      if (!size) errors.push_back({field + ".size_m", value, "must be WxH or XxYxZ in metres"});
    } else if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      errors.push_back(
          {field + "." + key, value, "unknown; " + recipe.kind + " takes size_m, " + Join(keys)});
    } else if (key == kWord) {
      if (IsWord(value)) recipe.words[key] = value;
      if (!IsWord(value)) {
        errors.push_back(
            {field + "." + key, value, "must be 1 to 12 of A to Z, 0 to 9 and spaces"});
      }
    } else if (const auto number = ToNumber(value)) {
      recipe.numbers[key] = *number;
    } else {
      errors.push_back({field + "." + key, value, "must be a number"});
    }
  }
  if (recipe.size_m.empty() && errors.empty()) {
    errors.push_back({field + ".size_m", "missing", "state the covered surface, WxH or XxYxZ"});
  }
  hardware::ThrowIfAny(std::move(errors));
  return recipe;
}

}  // namespace horopter::sim
