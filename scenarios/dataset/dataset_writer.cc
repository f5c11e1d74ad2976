// SPDX-License-Identifier: Apache-2.0
#include "scenarios/dataset/dataset_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <system_error>
#include <utility>

#include "scenarios/dataset/csv.h"
#include "scenarios/dataset/frame_files.h"
#include "scenarios/results/files.h"
#include "scenarios/results/results_error.h"
#include "scenarios/results/text.h"

namespace horopter::scenarios {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegrees = 180 / M_PI;

std::string Sha256(std::string_view bytes) {
  Hasher hasher;
  hasher.Update(std::as_bytes(std::span(bytes)));
  return hasher.Hex();
}

std::string Sha256OfFile(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  if (!stream) throw ResultsError("cannot read " + file.string());
  return Sha256(bytes.str());
}

void RequireFresh(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error) || fs::is_empty(folder, error)) return;
  throw ResultsError(
      fmt::format("cannot write a data set to {}: it is not an empty folder; remove "
                  "it or choose another",
                  folder.string()));
}

std::string LegendCsv(const sim::SceneLegend& legend) {
  std::string text = "kind,value,name,object_value\n";
  for (int part = 0; part < legend.part_count(); ++part) {
    text += fmt::format("part,{},{},{}\n", part + 1, CsvField(legend.PartName(part)),
                        legend.ObjectOf(part) + 1);
  }
  for (int object = 0; object < legend.object_count(); ++object) {
    text += fmt::format("object,{0},{1},{0}\n", object + 1, CsvField(legend.ObjectName(object)));
  }
  return text;
}

/// How the files are to be read; seed null says that the scene is as it is written down.
Json Conventions() {
  return {
      {"pixel_origin", "centre of the top left pixel"},
      {"optical_frame", "x right, y down, z forward"},
      {"depth", "metres along z of the optical frame; inf = nothing there"},
      {"normals",
       "outward, unit length, in the optical frame of the camera that the file is named after; "
       "inf = nothing there"},
      {"disparity",
       "left_disparity lies on the left image's pixels: what it shows at (x, y) the other eye sees "
       "at (x + dx, y + dy)"},
      {"A_to_B_disparity", "the same between two cameras, on the pixels of A's image"},
      {"flow",
       "flow_previous_to_this lies on the pixels of the previous frame: what that showed at (x, y) "
       "this frame shows at (x + dx, y + dy)"},
      {"truth_instant",
       "the middle of the whole image's exposure, seen as by a global shutter: rows of a rolling "
       "shutter, and fields of an interlaced one, are exposed up to half a readout before or "
       "after it (capture.csv says when), and a moving image lies beside its truth by that much "
       "motion"},
      {"faults",
       "truth shows eyes where faults have put them; of frozen frames and of a swapped pair it is "
       "what the camera named in the file would have shown at its time of capture"},
      {"visibility",
       {{"of", "the pixel that the file lies on, in the image that it leads to"},
        {"seen", 255},
        {"occluded", 128},
        {"out_of_view", 64},
        {"nothing", 0}}},
      {"ids", "id plus one, named in legend.csv; 0 = nothing there"},
      {"poses", "of bodies in the world frame W; in the request in the robot's starting frame O"},
      {"seed", "null = the scene as it is written down"}};
}

Json HashesOf(const SceneHashes& scene) {
  return {{"mjcf", scene.mjcf}, {"textures", scene.textures}, {"files", scene.files}};
}

std::string IndexHeader() {
  std::string header = "frame,folder,t_s";
  for (const std::string_view axis : hardware::kHeadAxisNames) {
    header += fmt::format(",{}_deg", axis);
  }
  return header;
}

std::string IndexRow(int frame, const std::string& folder, const DatasetFrame& content) {
  std::string row = fmt::format("{},{},{:.9f}", frame, folder, hardware::ToSeconds(content.t));
  for (const double angle : hardware::ToArray(content.head)) {
    // Adding nothing makes -0 to 0.
    row += fmt::format(",{}", std::round(angle * kDegrees * 1e6) / 1e6 + 0.0);
  }
  return row;
}

/// A folder under a temporary name, removed unless it is renamed.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(fs::path path) : path_(std::move(path)) {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    CreateFolder(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }

  const fs::path& path() const { return path_; }
  void RenameTo(const fs::path& folder) {
    std::error_code error;
    fs::rename(path_, folder, error);
    if (error) throw ResultsError(WriteFailure(folder, error.value()));
    path_.clear();
  }

 private:
  fs::path path_;
};

}  // namespace

DatasetWriter::DatasetWriter(fs::path folder, const DatasetInfo& info,
                             const std::optional<sim::SceneLegend>& legend,
                             const DatasetOptions& options)
    : folder_(std::move(folder)), info_(info), legend_(legend), options_(options) {
  RequireFresh(folder_);
  CreateFolder(folder_);
  WriteManifest(false);
  if (legend_) WriteFileAtomically(folder_ / "legend.csv", LegendCsv(*legend_));
  index_.emplace(folder_ / "index.csv", IndexHeader());
}

fs::path DatasetWriter::AddFrame(const DatasetFrame& frame) {
  const FrameFiles files = EncodeFrame(frame, legend_ ? &*legend_ : nullptr, options_);
  const std::string name = fmt::format("{:06}", frame_count_);
  TemporaryFolder temporary(folder_ / ("." + name + ".tmp"));
  std::string sums;
  std::map<std::string, std::string> hashes;
  for (const auto& [file, bytes] : files.bytes) {
    WriteFileAtomically(temporary.path() / file, bytes, Durability::kProcess);
    hashes[file] = Sha256(bytes);
    sums += fmt::format("{}  {}\n", hashes[file], file);
  }
  WriteFileAtomically(temporary.path() / "SHA256SUMS", sums, Durability::kProcess);
  file_hashes_[name + "/SHA256SUMS"] = Sha256(sums);
  temporary.RenameTo(folder_ / name);
  index_->Append(IndexRow(frame_count_, name, frame));
  for (const std::string& image : files.images) image_hashes_[name + "/" + image] = hashes[image];
  for (const auto& [file, count] : files.left_out) left_out_[name + "/" + file] = count;
  ++frame_count_;
  return folder_ / name;
}

void DatasetWriter::Finish(const std::vector<std::string>& others, const std::string& outcome) {
  outcome_ = outcome;
  std::vector<std::string> files = {"index.csv"};
  if (legend_) files.push_back("legend.csv");
  files.insert(files.end(), others.begin(), others.end());
  for (const std::string& file : files) file_hashes_[file] = Sha256OfFile(folder_ / file);
  WriteManifest(true);
}

void DatasetWriter::WriteManifest(bool complete) const {
  std::string all;
  for (const auto& [file, hash] : image_hashes_) all += hash;
  Json manifest = {{"format", "horopter data set"},
                   {"format_version", 2},
                   {"complete", complete},
                   {"scene", info_.scene},
                   {"scene_sha256", HashesOf(info_.scene_sha256)},
                   {"robot", info_.robot},
                   {"seed", info_.seed ? Json(*info_.seed) : Json(nullptr)},
                   {"command", info_.command},
                   {"request", info_.request.empty() ? Json(nullptr) : Json::parse(info_.request)},
                   {"left_out_of_profile", info_.left_out_of_profile},
                   {"gl_backend", info_.gl_backend},
                   {"gl_renderer", info_.gl_renderer},
                   {"versions", info_.versions},
                   {"frames", frame_count_},
                   {"conventions", Conventions()},
                   {"images_sha256", Sha256(all)},
                   {"images", image_hashes_},
                   {"files", file_hashes_}};
  if (!outcome_.empty()) manifest["motion_outcome"] = Json::parse(outcome_);
  if (options_.png16) {
    manifest["png16"] = {{"depth_units_per_m", options_.depth_units_per_m},
                         {"left_out", left_out_}};
  }
  WriteFileAtomically(folder_ / "manifest.json", manifest.dump(2) + "\n");
}

}  // namespace horopter::scenarios
