// SPDX-License-Identifier: Apache-2.0
#include "scenarios/cli/doctor.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "scenarios/format/backends.h"
#include "scenarios/format/scenes.h"
#include "scenarios/runner/machine.h"
#include "scenarios/runner/versions.h"
#include "sim/render/gl_context.h"

namespace horopter::scenarios {
namespace {

std::vector<std::string> CpuFeatures() {
  std::vector<std::string> features;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("sse4.2")) features.emplace_back("sse4.2");
  if (__builtin_cpu_supports("avx")) features.emplace_back("avx");
  if (__builtin_cpu_supports("avx2")) features.emplace_back("avx2");
  if (__builtin_cpu_supports("fma")) features.emplace_back("fma");
  if (__builtin_cpu_supports("avx512f")) features.emplace_back("avx512f");
#elif defined(__aarch64__)
  features.emplace_back("neon");
#endif
  return features;
}

GlDiagnosis DiagnoseGl(std::string_view backend) {
  const sim::GlProbe probe = sim::ProbeGlBackend(backend);
  return {std::string(backend), probe.renderer, probe.problem};
}

std::vector<std::string> Warnings() {
  std::vector<std::string> warnings;
  const char* width = std::getenv("LP_NATIVE_VECTOR_WIDTH");
  if (width != nullptr && std::string_view(width) == "512") {
    warnings.emplace_back("LP_NATIVE_VECTOR_WIDTH=512 crashes llvmpipe 22.3: unset it or say 256");
  }
  return warnings;
}

std::string SimProblem(const Diagnosis& d) {
  const bool gl =
      std::any_of(d.gl.begin(), d.gl.end(), [](const GlDiagnosis& g) { return g.problem.empty(); });
  if (!gl) return "no GL context: install libosmesa6 or libegl1";
  if (d.scenes.empty()) {
    return "no scenes in " + d.scenes_dir + ": set HOROPTER_SCENES_DIR to the folder of scenes";
  }
  return d.robots.empty() ? "no robot.yaml in a folder of " + d.scenes_dir : "";
}

}  // namespace

bool Diagnosis::Usable(const std::string& backend) const {
  return std::any_of(backends.begin(), backends.end(), [&backend](const BackendDiagnosis& b) {
    return b.name == backend && b.problem.empty();
  });
}

Diagnosis Diagnose() {
  Diagnosis d;
  d.versions = LibraryVersions();
  const Machine machine = ThisMachine();
  d.processor = machine.processor;
  d.cores = machine.cores;
  d.cpu_features = CpuFeatures();
  for (std::string_view backend : sim::GlBackends()) d.gl.push_back(DiagnoseGl(backend));
  d.scenes_dir = ScenesDir().string();
  d.robots = RobotNames(d.scenes_dir);
  d.scenes = SceneNames(d.scenes_dir);
  for (const BackendInfo& backend : Backends()) {
    d.backends.push_back(
        {backend.name, backend.doc, backend.name == "sim" ? SimProblem(d) : backend.missing});
  }
  d.warnings = Warnings();
  return d;
}

}  // namespace horopter::scenarios
