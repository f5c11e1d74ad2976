// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <nlohmann/json.hpp>

#include "scenarios/cli/commands.h"
#include "scenarios/cli/doctor.h"
#include "scenarios/runner/exit_code.h"

namespace horopter::scenarios {
namespace {

nlohmann::ordered_json ToJson(const Diagnosis& d) {
  nlohmann::ordered_json gl = nlohmann::ordered_json::array();
  for (const GlDiagnosis& g : d.gl) {
    gl.push_back({{"backend", g.backend},
                  {"usable", g.problem.empty()},
                  {"renderer", g.renderer},
                  {"problem", g.problem}});
  }
  nlohmann::ordered_json backends = nlohmann::ordered_json::array();
  for (const BackendDiagnosis& b : d.backends) {
    backends.push_back({{"name", b.name},
                        {"usable", b.problem.empty()},
                        {"needs", b.doc},
                        {"problem", b.problem}});
  }
  return {{"versions", d.versions},
          {"processor", d.processor},
          {"cores", d.cores},
          {"cpu_features", d.cpu_features},
          {"gl", std::move(gl)},
          {"scenes_dir", d.scenes_dir},
          {"robots", d.robots},
          {"scenes", d.scenes},
          {"backends", std::move(backends)},
          {"warnings", d.warnings}};
}

void Print(const Diagnosis& d) {
  fmt::print("Versions\n");
  for (const auto& [library, version] : d.versions) fmt::print("  {:<9} {}\n", library, version);
  fmt::print("Processor\n  {}, {} cores, {}\n", d.processor.empty() ? "unknown" : d.processor,
             d.cores, fmt::join(d.cpu_features, " "));
  fmt::print("Rendering\n");
  for (const GlDiagnosis& g : d.gl) {
    fmt::print("  {:<9} {}\n", g.backend, g.problem.empty() ? g.renderer : "no: " + g.problem);
  }
  fmt::print("Scenes in {}\n  robots: {}; {} models\n", d.scenes_dir, fmt::join(d.robots, ", "),
             d.scenes.size());
  fmt::print("Backends\n");
  for (const BackendDiagnosis& b : d.backends) {
    fmt::print("  {:<9} {}\n  {:<9} {}\n", b.name, b.problem.empty() ? "ready" : "not available",
               "", b.doc);
    if (!b.problem.empty()) fmt::print("  {:<9} {}\n", "", b.problem);
  }
  for (const std::string& warning : d.warnings) fmt::print("Warning: {}\n", warning);
}

}  // namespace

Command AddDoctorCommand(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand(
      "doctor", "Say what this machine has: GL, versions, processor, and what each backend needs");
  // Shared by CLI11, which writes into it while parsing, and the closure that runs afterwards.
  const auto json = std::make_shared<bool>(false);
  app->add_flag("--json", *json, "As JSON");
  app->footer(
      "\nExample:\n  horopter doctor --json\n\n"
      "Exit code 3 when not even the sim backend can be used.");
  return {app, [json] {
            const Diagnosis diagnosis = Diagnose();
            if (*json) {
              fmt::print("{}\n", ToJson(diagnosis).dump(2));
            } else {
              Print(diagnosis);
            }
            return static_cast<int>(diagnosis.Usable("sim") ? ExitCode::kPassed
                                                            : ExitCode::kInfrastructure);
          }};
}

}  // namespace horopter::scenarios
