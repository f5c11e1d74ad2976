// SPDX-License-Identifier: Apache-2.0
#include "scenarios/render/render_request.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "scenarios/dataset/format_error.h"
#include "scenarios/format/camera_fields.h"
#include "scenarios/format/fault_fields.h"
#include "scenarios/format/field_parser.h"
#include "scenarios/format/field_writer.h"
#include "scenarios/format/scenario_fields.h"
#include "sim/tabletop/light_colour.h"

namespace horopter::scenarios {
namespace {

using Json = nlohmann::ordered_json;

void Visit(FieldVisitor& v, GeneratedRoom& r) {
  v.Numbers({"goal_m", "m", "Where the free path leads, in the robot's starting frame."},
            {-100, 100}, {r.goal_m.data(), 2});
  Visit(v, r.spec);
}

void Visit(FieldVisitor& v, TableSpec& t) {
  v.Integral({"clutter", "", "Things on the table that belong to no experiment."}, {0, 100},
             t.clutter);
  v.Number({"occluded", "", "Share of the target that is hidden; left out: none."}, {0.05, 0.95},
           t.occluded);
  v.Text({"background", "", "Behind the table; left out: drawn."}, {}, t.background);
  v.Number({"brightness", "", "Of all lights; 1: as the scene has them."}, {0.05, 2}, t.brightness);
  v.Number({"colour_temperature_k", "K", "Of all lights."},
           {sim::kLowestColourTemperature_k, sim::kHighestColourTemperature_k},
           t.colour_temperature_k);
}

template <typename T>
OptionalSection SectionOf(const char* key, const char* doc, std::optional<T>& value) {
  return {{key, "", doc}, value.has_value(), [&value](FieldVisitor& v) {
            if (!value) value.emplace();
            Visit(v, *value);
          }};
}

/// All but the seed, which may be null, and the poses, which are a table.
void Visit(FieldVisitor& v, RenderRequest& r) {
  v.Text({"scene", "", "Below the scenes folder.", true}, {}, r.scene);
  v.Text({"robot", "", "A folder of the scenes folder.", true}, {}, r.robot);
  v.Optional(SectionOf("room", "Obstacles generated in the scene's walls.", r.room));
  v.Optional(SectionOf("table", "What is varied on a tabletop.", r.table));
  v.TextList({"pairs", "", "Pairs of the robot's cameras; none: all."}, {}, r.pairs);
  v.Section({"camera", "", "As a scenario has it; size and field of view left out: the robot's."},
            [&r](FieldVisitor& w) { Visit(w, r.camera); });
  v.Flag({"supersample", "", "Four samples per pixel."}, r.supersample);
  v.Text({"gl", "", "GL backend."}, {}, r.gl);
  v.Flag({"truth", "", "Depth, ids, normals, disparity, flow, states."}, r.truth);
  v.Flag({"png16", "", "Truth as 16-bit PNG as well."}, r.png16);
  v.TextList({"truth_between", "", "Other pairs of cameras with disparity, FROM:TO."}, {},
             r.between);
  v.TextList({"views", "", "The scene by its own cameras."}, {}, r.views);
  v.Optional(SectionOf("motion", "What the robot does while its cameras run.", r.motion));
  v.Alternatives(FaultList(r.faults));
}

FieldTable TableOf(RenderRequest& request) {
  return [&request](FieldVisitor& v) { Visit(v, request); };
}

}  // namespace

std::string EncodeRequest(const RenderRequest& request) {
  RenderRequest copy = request;  // the writer reads through the same table as the parser
  Json json = ToJson(ParseYaml(WriteFields(TableOf(copy)), "request"));
  json["seed"] = request.seed ? Json(*request.seed) : Json(nullptr);
  json["poses"] = {{"columns", request.poses.columns}, {"rows", request.poses.rows}};
  return json.dump();
}

RenderRequest DecodeRequest(const std::string& text, const std::string& name) {
  RenderRequest request;
  try {
    Json json = Json::parse(text);
    if (const Json& seed = json.at("seed"); !seed.is_null()) {
      request.seed = seed.get<std::uint64_t>();
    }
    json.at("poses").at("columns").get_to(request.poses.columns);
    json.at("poses").at("rows").get_to(request.poses.rows);
    json.erase("seed");
    json.erase("poses");
    ParseReport report;
    ParseFields(ParseYaml(json.dump(), name), TableOf(request), report);
    ThrowIfAny(std::move(report.diagnostics));
  } catch (const Json::exception& error) {
    throw FormatError(name + ": no request that a data set could be made from: " + error.what());
  }
  for (const auto& row : request.poses.rows) {
    if (row.size() == request.poses.columns.size()) continue;
    throw FormatError(name + ": poses: a row is not as long as the list of columns");
  }
  return request;
}

}  // namespace horopter::scenarios
