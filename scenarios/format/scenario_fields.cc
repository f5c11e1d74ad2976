// SPDX-License-Identifier: Apache-2.0
#include "scenarios/format/scenario_fields.h"

#include <utility>

#include "scenarios/format/backends.h"
#include "scenarios/format/camera_fields.h"
#include "scenarios/format/expectation_parser.h"
#include "scenarios/format/fault_fields.h"

namespace horopter::scenarios {
namespace {

// Beyond 2^53 - 1 JSON readers lose digits of a seed.
constexpr double kLargestSeed = 9007199254740991.0;
constexpr double kFarthest_m = 100;
constexpr double kLongest_s = 3600;

constexpr Range kPlace{-kFarthest_m, kFarthest_m};
constexpr Range kHold{0, kLongest_s};
constexpr Range kPositiveTime{0, kLongest_s, true};

// What the navigator and its controllers can do: they stop within 5 cm, creep at 3 cm/s, and see no
// obstacle beyond 3 m.
constexpr Range kObstacles{0, 30};
constexpr Range kTolerance{0.05, 10};
constexpr Range kCruiseSpeed{0.03, 2};
constexpr Range kObstacleLimit{0, 3, true};

const TextRule kName{"[A-Za-z0-9][A-Za-z0-9_.-]*(?: [A-Za-z0-9_.-]+)*",
                     "words of letters, digits, '_', '-' and '.', a space between them", 80};
const TextRule kFolderName{"[A-Za-z0-9][A-Za-z0-9_.-]*",
                           "letters, digits, '_', '-' and '.', beginning with a letter or digit",
                           80};
const TextRule kTag{"[a-z0-9][a-z0-9_-]*", "lower-case letters, digits, '-' and '_'", 40};
const TextRule kScenePath{R"((?:[A-Za-z0-9_-][A-Za-z0-9_.-]*/)*[A-Za-z0-9_-][A-Za-z0-9_.-]*\.xml)",
                          "the path of an .xml file below the scenes folder, e.g. koala/room.xml",
                          200};
const TextRule kBodyName{"[A-Za-z_][A-Za-z0-9_.-]*", "the name of a body of the scene", 80};

void Visit(FieldVisitor& v, VariationSpec& s) {
  v.Number({"obstacles_m", "m",
            "How far a seed moves each obstacle of the scene, at most; not those of a room."},
           {0, 2}, s.obstacles_m);
  v.Number({"heading_deg", "deg", "How far a seed turns the robot's start, at most."}, {0, 180},
           s.heading_deg);
  v.Flag({"textures", "", "Whether a seed repaints the textures."}, s.textures);
}

void Visit(FieldVisitor& v, BodyPlacement& s) {
  v.Numbers({"position_m", "m", "x forward, y left, z up, in the robot's starting frame.", true},
            kPlace, {s.position_m.data(), 3});
  v.Number({"yaw_deg", "deg", "Turn about the vertical, counter-clockwise."}, {-360, 360},
           s.yaw_deg);
  v.Number({"pitch_deg", "deg", "Then about its own y axis: its front down."}, {-360, 360},
           s.pitch_deg);
  v.Number({"roll_deg", "deg", "Then about its own x axis: its left side up."}, {-360, 360},
           s.roll_deg);
}

void Visit(FieldVisitor& v, HeadSpec& s) {
  v.Number({"encoder_step_deg", "deg",
            "Quantum of the angles that the head reports; 0 = none; left out: the robot's."},
           {0, 5}, s.encoder_step_deg);
  v.Number({"encoder_noise_deg", "deg", "Standard deviation of the noise on reported angles."},
           {0, 5}, s.encoder_noise_deg);
}

void Visit(FieldVisitor& v, VisionSpec& s) {
  v.Choice({"method", "", "How disparity is found."}, {"v1"}, s.method);
  v.Choice({"preset", "", "Settings of the method: fit to drive by, denser, or as published."},
           {"cautious", "checked", "paper_2009"}, s.preset);
  v.Integral({"scales", "", "Levels of the image pyramid, coarse to fine."}, {1, 8}, s.scales);
  v.Number({"rate_hz", "Hz",
            "Vision cycles per simulated second, at most; one begins when the last has ended."},
           {0, 60, true}, s.rate_hz);
  v.Number({"latency_s", "s", "Modelled time from capture to result."}, {0, 10}, s.latency_s);
  v.Integral({"median_px", "px", "Side of the median filter before segmentation."}, {1, 51},
             s.median_px);
  v.Integral({"edge_threshold", "", "Colour difference that makes an edge, in grey levels."},
             {1, 255}, s.edge_threshold);
}

void Visit(FieldVisitor& v, NavigationSpec& s) {
  v.Choice({"rule", "",
            "How obstacles are avoided: by the paper's rule alone, or with its additions for a "
            "robot with a width and a narrow view."},
           {"paper", "corridor"}, s.rule);
  v.Number({"obstacle_limit_m", "m", "What is nearer than this is avoided."}, kObstacleLimit,
           s.obstacle_limit_m);
  v.Number({"cruise_speed_m_s", "m/s", "Speed on a free straight."}, kCruiseSpeed,
           s.cruise_speed_m_s);
}

void Visit(FieldVisitor& v, GotoStep& s) {
  v.Number({"x_m", "m", "Goal, forward in the robot's starting frame.", true}, kPlace,
           s.goal_m.x());
  v.Number({"y_m", "m", "Goal, to the left.", true}, kPlace, s.goal_m.y());
  v.Number({"tolerance_m", "m", "How near counts as reached, by odometry."}, kTolerance,
           s.tolerance_m);
  v.Number({"timeout_s", "s", "The step gives up after this."}, kPositiveTime, s.timeout_s);
}

void VisitTarget(FieldVisitor& v, Eigen::Vector3d& target_m, double& hold_s) {
  v.Number({"x_m", "m", "Target, forward in the robot's starting frame.", true}, kPlace,
           target_m.x());
  v.Number({"y_m", "m", "Target, to the left.", true}, kPlace, target_m.y());
  v.Number({"z_m", "m", "Target, above the floor.", true}, kPlace, target_m.z());
  v.Number({"hold_s", "s", "How long the gaze stays."}, kHold, hold_s);
}

void Visit(FieldVisitor& v, FixateStep& s) { VisitTarget(v, s.target_m, s.hold_s); }
void Visit(FieldVisitor& v, LookAtStep& s) { VisitTarget(v, s.target_m, s.hold_s); }

void Visit(FieldVisitor& v, SaccadeStep& s) {
  v.Number({"pan_deg", "deg", "Mean pan of both eyes, positive to the left."}, {-180, 180},
           s.pan_deg);
  v.Number({"tilt_deg", "deg", "Tilt of both eyes, positive down."}, {-90, 90}, s.tilt_deg);
  v.Number({"vergence_deg", "deg", "Angle between the optical axes, positive when they converge."},
           {-30, 120}, s.vergence_deg);
  v.Number({"hold_s", "s", "How long the gaze stays."}, kHold, s.hold_s);
}

void Visit(FieldVisitor& v, WaitStep& s) {
  v.Number({"duration_s", "s", "How long.", true}, kPositiveTime, s.duration_s);
}

/// The alternative that makes `action` an `Action`, keeping what it has when it is one.
template <typename Action>
Alternative StepKind(const char* key, const char* doc, StepAction& action) {
  return {{key, "", doc}, std::holds_alternative<Action>(action), [&action](FieldVisitor& v) {
            if (!std::holds_alternative<Action>(action)) action = Action{};
            Visit(v, std::get<Action>(action));
          }};
}

AlternativeList StepList(std::vector<Step>& steps) {
  return {
      {"steps", "", "What the robot does, one after the other.", true},
      steps.size(),
      [&steps](std::size_t index, const SourceMark& mark) {
        if (index == steps.size()) steps.push_back({mark, GotoStep{}});
        StepAction& action = steps[index].action;
        return std::vector<Alternative>{
            StepKind<GotoStep>("goto", "Drive to a place round what the cameras see.", action),
            StepKind<FixateStep>("fixate", "Both optical axes meet in a point.", action),
            StepKind<LookAtStep>("look_at", "Both optical axes point one way, parallel.", action),
            StepKind<SaccadeStep>("saccade", "Turn the eyes to given angles.", action),
            StepKind<WaitStep>("wait", "Let time pass.", action)};
      }};
}

SentenceList ExpectationList(std::vector<Expectation>& expectations) {
  std::vector<std::string> texts;
  for (const Expectation& e : expectations) texts.push_back(e.text);
  return {{"expect", "",
           "What must hold of the run: METRIC OP VALUE [UNIT], or reached within D m "
           "before T s.",
           true},
          ExpectationPattern(),
          std::move(texts),
          [&expectations](const std::string& text, const SourceMark& mark) -> std::string {
            auto parsed = ParseExpectation(text);
            if (const auto* fault = std::get_if<std::string>(&parsed)) return *fault;
            auto& expectation = std::get<Expectation>(parsed);
            expectation.mark = mark;
            for (const Expectation& e : expectations) {
              if (e.text == expectation.text) return "stands twice: keep one of them";
            }
            expectations.push_back(std::move(expectation));
            return "";
          }};
}

OptionalSection RoomSection(std::optional<RoomSpec>& room) {
  return {{"room", "", "A room that the seed generates, in a scene without obstacles."},
          room.has_value(),
          [&room](FieldVisitor& v) {
            if (!room) room.emplace();
            Visit(v, *room);
          }};
}

template <typename T>
FieldTable TableOf(T& value) {
  return [&value](FieldVisitor& v) { Visit(v, value); };
}

NamedMap BodyMap(std::map<std::string, BodyPlacement>& bodies) {
  std::vector<std::string> names;
  for (const auto& [name, placement] : bodies) names.push_back(name);
  return {{"bodies", "", "Where bodies of the scene stand instead of where the scene puts them."},
          kBodyName,
          std::move(names),
          [&bodies](const std::string& name) { return TableOf(bodies[name]); }};
}

}  // namespace

void Visit(FieldVisitor& v, RoomSpec& s) {
  v.Integral({"min_obstacles", "", "How many obstacles a seed puts into the room, at least."},
             kObstacles, s.min_obstacles);
  v.Integral({"max_obstacles", "", "How many it puts there at most, a barrier apart."}, kObstacles,
             s.max_obstacles);
  v.Choice({"path", "",
            "Whether a path leads from the start over all goals, or screens block the way to the "
            "first one."},
           {"free", "blocked"}, s.path);
  v.Number({"clearance_m", "m", "How far from everything the free path keeps the robot."},
           {0, 2, true}, s.clearance_m);
  v.Choice({"lighting", "", "How the room is lit: chosen by the seed, as the scene has it, or so."},
           {"varied", "as_built", "daylight", "evening", "lamps", "overcast"}, s.lighting);
  v.Flag({"surfaces", "", "Whether a seed changes floor, walls and fabrics."}, s.surfaces);
  v.Flag({"furniture", "", "Whether a seed moves furniture along its walls."}, s.furniture);
}

void Visit(FieldVisitor& v, Scenario& s) {
  v.Text({"name", "", "Heads lists and reports; the file's name without .yaml when left out."},
         kName, s.name);
  v.Text({"description", "", "One sentence for lists and reports."}, {"", "", 500}, s.description);
  v.TextList({"tags", "", "What --tag selects by."}, kTag, s.tags);
  v.Text({"scene", "", "MuJoCo model below the scenes folder, e.g. koala/room.xml.", true},
         kScenePath, s.scene);
  v.Text({"robot", "",
          "Robot that stands in the scene: a folder of the scenes folder with a "
          "robot.yaml."},
         kFolderName, s.robot);
  v.Choice({"backend", "", "What the robot is made of."}, BackendNames(), s.backend);
  v.Choice({"gl", "", "What simulated images are rendered with; never replaced by another."},
           {"osmesa", "egl"}, s.gl);
  v.Integral({"seed", "", "Varies what a lab would vary; the command line may replace it."},
             {0, kLargestSeed}, s.seed);
  v.Number({"time_limit_s", "s", "Simulated time after which a run that has not ended fails."},
           kPositiveTime, s.time_limit_s);
  v.Section({"variation", "", "What a seed changes."}, TableOf(s.variation));
  v.Map(BodyMap(s.bodies));
  v.Optional(RoomSection(s.room));
  v.Section({"camera", "", "Both eyes."}, TableOf(s.camera));
  v.Section({"head", "", "The head's encoders."}, TableOf(s.head));
  v.Section({"vision", "", "From images to depth and regions."}, TableOf(s.vision));
  v.Section({"navigation", "", "From regions to wheel speeds."}, TableOf(s.navigation));
  v.Alternatives(FaultList(s.faults));
  v.Alternatives(StepList(s.steps));
  v.Sentences(ExpectationList(s.expect));
}

}  // namespace horopter::scenarios
