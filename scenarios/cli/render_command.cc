// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <unistd.h>

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>

#include "hardware/types/config_error.h"
#include "scenarios/cli/commands.h"
#include "scenarios/cli/render_options.h"
#include "scenarios/dataset/png16.h"
#include "scenarios/render/contact_sheet.h"
#include "scenarios/render/manifest.h"
#include "scenarios/render/render_dataset.h"
#include "scenarios/runner/exit_code.h"
#include "scenarios/runner/run_process.h"
#include "scenarios/runner/versions.h"

namespace horopter::scenarios {
namespace {

/// @return whether it ran to its end
bool Make(const RenderRequest& request, const std::string& command, const RenderArguments& a) {
  InstallStopHandler();
  ContactSheet sheet;
  RenderHooks hooks;
  hooks.interrupted = StopRequested;
  const bool shows_progress = isatty(STDERR_FILENO) != 0;
  int expected = 1;
  hooks.progress = [&](int done, int all) {
    expected = all;
    if (!shows_progress || all < 2) return;
    std::cerr << fmt::format("\rframe {} of {}", done + 1, all) << std::flush;
  };
  std::string note;
  hooks.note = [&note](const std::string& line) { note = line; };
  int frames = 0;
  hooks.frame = [&](const DatasetFrame& f) {
    if (!a.sheet.empty()) sheet.AddSpread(f, frames, expected);
    ++frames;
  };
  const RenderOutput output{a.out, command, LibraryVersions()};
  const bool whole = RenderDataset(request, output, hooks);
  if (shows_progress && frames > 1) std::cerr << "\n";
  if (!note.empty()) std::cerr << "horopter render: " << note << "\n";
  if (!sheet.picture().empty()) WritePng(a.sheet, sheet.picture());
  if (whole) {
    fmt::print("{} frames: {}\n", frames, (output.folder / "manifest.json").string());
  } else {
    std::cerr << "horopter render: interrupted; " << a.out << " holds what was finished\n";
  }
  return whole;
}

int Again(const RenderArguments& a) {
  const DatasetManifest before = ReadManifest(a.again);
  if (const std::string changed = WhatChangedSince(before); !changed.empty()) {
    std::cerr << "horopter render: " << changed << "\n";
  }
  if (!Make(before.request, before.command, a)) return static_cast<int>(ExitCode::kInfrastructure);
  const std::string different = WhatDiffers(before, ReadManifest(a.out));
  if (different.empty()) return static_cast<int>(ExitCode::kPassed);
  std::cerr << "horopter render: " << different << "\n";
  return static_cast<int>(ExitCode::kExpectationFailed);
}

int Render(const RenderArguments& a, const std::string& command) {
  if (!a.again.empty()) return Again(a);
  if (a.scene.empty()) {
    throw hardware::ConfigError(
        {{"SCENE", "''", "must be given, e.g. koala/room.xml, or --again MANIFEST"}});
  }
  return static_cast<int>(Make(RequestOf(a), command, a) ? ExitCode::kPassed
                                                         : ExitCode::kInfrastructure);
}

}  // namespace

Command AddRenderCommand(CLI::App& parent, const std::string& command_line) {
  CLI::App* app = parent.add_subcommand(
      "render", "Make a data set: stereo pairs of a scene at given gazes, with exact truth");
  // Shared by CLI11, which writes into it while parsing, and the closure that runs afterwards.
  const auto a = std::make_shared<RenderArguments>();
  AddRenderOptions(*app, *a);
  return {app, [a, command_line] { return Render(*a, command_line); }};
}

}  // namespace horopter::scenarios
